// STAFF ONLY. Replays a case of grading without the grader: each folder of `hairgrade reproduce` has a copy.
// Objects that the case gave to the student's code, such as a matrix, answer as they answered in grading.
#pragma once

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "grader/calls/remote.h"

namespace replay {

using Numbers = std::vector<double>;

inline Eigen::VectorXd vector(std::initializer_list<double> numbers) {
  return Eigen::VectorXd::Map(numbers.begin(), static_cast<Eigen::Index>(numbers.size()));
}
inline Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index cols, std::initializer_list<double> numbers) {
  return Eigen::MatrixXd::Map(numbers.begin(), rows, cols);
}
// Lives as long as the program, for structs that only refer to their numbers.
inline Eigen::Map<const Eigen::VectorXd> kept(std::initializer_list<double> numbers) {
  const auto* all = new Eigen::VectorXd(vector(numbers));
  return {all->data(), all->size()};
}

// Asks an object of the student's as grading did.
inline void ask(implicitMatrix& matrix, Eigen::VectorXd question, Eigen::Index rows) {
  Eigen::VectorXd answer = Eigen::VectorXd::Zero(rows);
  matrix.matVecMult(question.data(), answer.data());
}

inline bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// Reads the answers of one call: lines of its number, the object's, a question and an answer, each with its
// length before it.
class Recorded {
 public:
  Recorded(const char* file, int call) : answers_(std::make_shared<std::map<std::string, Numbers>>()) {
    std::ifstream in(file);
    for (int number, which; in >> number >> which;) {
      const Numbers question = read(in);
      Numbers answer = read(in);
      if (number == call) answers_->emplace(key(which, question.data(), question.size()), std::move(answer));
    }
  }
  void ask(const grader::Question& question) const {
    const auto found = answers_->find(key(question.which, question.numbers.data(), question.numbers.size()));
    if (found == answers_->end())
      throw std::runtime_error(
          "grading was not asked this question, so there is no answer; hairgrade try asks a changed file");
    std::copy(found->second.begin(), found->second.end(), question.answer.begin());
  }

 private:
  static Numbers read(std::istream& in) {
    std::size_t size = 0;
    in >> size;
    Numbers numbers(size);
    std::string word;
    for (double& number : numbers) in >> word, number = std::strtod(word.c_str(), nullptr);
    return numbers;
  }
  static std::string key(int which, const double* numbers, std::size_t size) {
    return std::to_string(which) + ":" +
           std::string(reinterpret_cast<const char*>(numbers), size * sizeof *numbers);
  }

  std::shared_ptr<std::map<std::string, Numbers>> answers_;
};

// Holds what grading saw in all calls, and what its check says.
struct Check {
  std::string says;
  Numbers seen;
  Numbers actual, expected;  // belong to the check
  std::ptrdiff_t first;      // is the place of `actual` in `seen`; -1: the check made it of several numbers
};

class Seen {
 public:
  template <class T>
  void add(const char* name, const T& value) {
    const std::size_t before = numbers_.size();
    if constexpr (requires { value.reshaped(); })
      for (const double number : value.reshaped()) numbers_.push_back(number);
    else if constexpr (requires { value.begin(); })
      for (const auto number : value) numbers_.push_back(static_cast<double>(number));
    else
      numbers_.push_back(static_cast<double>(value));
    std::cout << name << " =";
    for (std::size_t i = before; i < numbers_.size(); ++i) std::cout << " " << numbers_[i];
    std::cout << "\n";
  }

  int compare(const Check& check) const {
    std::size_t differ = numbers_.size() != check.seen.size();
    for (std::size_t i = 0; i < numbers_.size() && i < check.seen.size(); ++i)
      differ += !same_bits(numbers_[i], check.seen[i]);
    std::cout << (differ == 0 ? "These are" : "These are not") << " the numbers that grading saw.\n\n"
              << check.says << "\n";
    for (std::size_t i = 0; i < check.expected.size(); ++i) {
      const std::size_t at = static_cast<std::size_t>(check.first) + i;
      const bool is_live = check.first >= 0 && at < numbers_.size();
      std::cout << "entry " << i << ": actual " << (is_live ? numbers_[at] : check.actual[i]) << ", expected "
                << check.expected[i] << "\n";
    }
    return 0;
  }

 private:
  Numbers numbers_;
};

}  // namespace replay

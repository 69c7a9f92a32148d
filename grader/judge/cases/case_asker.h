// STAFF ONLY. A case as a client's asker (grader/calls/client.h): calls the student's worker, and ends the
// category if there is no answer. All calls through one asker are one case.
#pragma once

#include <limits>
#include <utility>

#include "grader/calls/client.h"
#include "grader/calls/in_words.h"
#include "grader/judge/cases/trial.h"

namespace grader::inline judge {

// Fills an Output before a call that must overwrite it.
inline constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
inline Eigen::VectorXd unset(Eigen::Index size) {
  return Eigen::VectorXd::Constant(size, kUnset);
}

class CaseAsker {
 public:
  // `stopped` is the feedback if the worker asks for too many products.
  explicit CaseAsker(Trial& trial, std::string stopped = kTooManyProducts)
      : trial_(trial), stopped_(std::move(stopped)) {}

  MessageReader ask(const MessageWriter& request, const Products& products) {
    return std::exchange(begun_, true) ? trial_.ask_on(request, products, stopped_)
                                       : trial_.ask(request, products, stopped_);
  }
  template <auto function>
  void start(MessageWriter&, const auto&... arguments) const {
    if (!begun_) trial_.describe_call(in_words<function>(arguments...));
  }
  bool served(const particles::Force&) const { return false; }
  void scratch(const auto&, int) {}
  void changed() { changed_input_ = true; }

  // True if a call changed an argument that the contract protects.
  bool changed_input() const { return changed_input_; }

 private:
  Trial& trial_;
  std::string stopped_;
  bool begun_ = false, changed_input_ = false;
};

// Makes a case: returns the answers of a student's function for these values; see answers().
template <class Calls, auto function>
inline constexpr auto answer_of = [](Trial& trial, const auto&... given) {
  CaseAsker asker(trial);
  return answers<Calls, function>(asker, given...);
};

}  // namespace grader::judge

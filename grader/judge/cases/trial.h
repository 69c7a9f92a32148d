// STAFF ONLY. A category of an exercise's hidden cases, and the tools for its code. A case is a call of the
// student's function, or a few calls in a row, with the checks of the answers until the next case. The first
// failing case ends its category; the number of failing cases is counted later.
//
// A failure is for staff: the missing property, the error's share of its limit, inputs, expected and actual
// values. Students read a fixed sentence (grader/report/facts/student_view.h).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grader/judge/cases/random.h"
#include "grader/judge/student/student.h"
#include "grader/result/result.h"

namespace grader::inline judge {

struct CaseFailed {
  Status status;
  std::string feedback, detail;
  std::string hint = {};  // see CaseResult, as for the next one
  double error_in_limits = 0;
};

inline constexpr const char* kTooManyProducts =
    "takes more products with the matrix than the step limit allows";

// Holds a student's numbers that belong together, and the expected ones. Wrong numbers may look like a known
// mistake, which the student reads. Such hints decide nothing.
struct Compared {
  Eigen::VectorXd actual, expected;
  int block = 3;                     // counts the numbers of a particle
  Eigen::VectorXd before = {};       // are the numbers before the call, or an input
  std::optional<double> bound = {};  // within this, numbers are the same; empty: the error's
};

inline Compared compared(double actual, double expected) {
  return {Eigen::VectorXd::Constant(1, actual), Eigen::VectorXd::Constant(1, expected), 1};
}

// Bounds the error of right answers. `promised` is the part that the contract allows, such as a tolerance;
// `rest` is the part that no program can avoid, such as rounding.
struct Bound {
  Bound(double most) : rest(most) {}
  Bound(double promised_error, double more) : promised(promised_error), rest(more) {}

  double promised = 0, rest;
  double most() const { return promised + rest; }
};

// A wrong answer ends the category by CaseFailed, or is counted. A missing answer ends it in both cases.
enum class WhenWrong { stop, count };

class Trial {
 public:
  Trial(Student& student, const Random& source, WhenWrong when_wrong = WhenWrong::stop)
      : random(source), student_(student), when_wrong_(when_wrong) {}

  // Returns the return value of the student's function. Throws CaseFailed if it did not return; with the
  // feedback `stopped` if `products` stopped it.
  MessageReader ask(const MessageWriter& request, const Products& products,
                    const std::string& stopped = kTooManyProducts);
  // Does the same for another call in the same case.
  MessageReader ask_on(const MessageWriter& request, const Products& products, const std::string& stopped);

  // Returns the reply in an answer; throws CaseFailed as above if there is none.
  MessageReader reply_of(Answer answer, const std::string& stopped = {}) const;

  // Describes the following cases for staff: "tridiagonal, n = 10".
  void describe(const std::string& text) { description_ = text, call_.clear(); }
  // Describes the call that begins a case (grader/calls/in_words.h).
  void describe_call(const std::string& text) { call_ = text; }

  void expect(bool holds, const std::string& feedback, const std::string& detail = {});
  // Ends the category if this does not hold, since the rest of the category needs it.
  void require(bool holds, const std::string& feedback, const std::string& detail = {},
               const std::string& hint = {});

  // error <= bound; otherwise staff read "<what> is 6.6 times the limit". NaN fails.
  void expect_at_most(double error, Bound bound, const std::string& what, const std::string& detail = {});
  void expect_at_most(double error, Bound bound, const std::string& what, const Compared& numbers,
                      const std::string& detail = {});
  // These do the same for the largest difference, and for the distance ||actual - expected||.
  void expect_near(const Compared& numbers, Bound bound, const std::string& what);
  void expect_close(const Compared& numbers, Bound bound, const std::string& what);

  [[noreturn]] void fail(Status status, const std::string& feedback, const std::string& detail,
                         const std::string& hint = {}, double error_in_limits = 0) const;

  // Belong to the last case, see Student.
  const std::vector<ProvidedSolve>& provided_solves() const { return student_.provided_solves(); }

  // Runs `questions` whose answers may excuse a mistake: they are no cases, and the first that fails ends
  // them.
  void ask_aside(const std::function<void()>& questions);

  // Returns how near errors came to their bounds: the largest (error - promised) / rest of each quantity.
  const std::map<std::string, double>& nearest() const { return nearest_; }

  // Holds the numbers of the check that failed; none if it compares none.
  const Compared& compared() const { return compared_; }

  int cases() const { return cases_; }
  int failed() const { return failed_; }

  Random random;

 private:
  void wrong(const std::string& feedback, const std::string& detail, const std::string& hint = {},
             double error_in_limits = 0);

  Student& student_;
  WhenWrong when_wrong_;
  std::string description_, call_;
  std::map<std::string, double> nearest_;
  Compared compared_;
  int cases_ = 0, failed_ = 0;
  bool case_failed_ = false, aside_ = false;
};

// This is a category as categories.json declares it.
struct Category {
  std::string name;   // its id: "Examples"
  std::string title;  // for students: "The lecture's examples"
  double weight;      // relative: an exercise's points are distributed by these weights
  std::function<void(Trial&)> run;
};

struct CaseCount {
  int cases = 0, held = 0;  // held < cases
};

// Counts the cases that hold in a failed category. Nothing if an answer is missing or the rest can't go on
// with it, or if no case fails this time.
std::optional<CaseCount> count_of(const Category& category, Student& student, const Random& source);

}  // namespace grader::judge

// STAFF ONLY. A category of an exercise's hidden cases, and the tools for its code. The first failing case
// ends its category.
//
// A failure has two readers. The student sees the missing property and the size of an error in bands; staff
// see inputs, expected and actual values.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "grader/report/result.h"
#include "grader/suite/random.h"
#include "grader/suite/student.h"

namespace grader {

struct CaseFailed {
  Status status;
  std::string feedback, detail;
};

class Trial {
 public:
  Trial(Student& student, const Random& source) : random(source), student_(student) {}

  // The return value of the student's function. Throws CaseFailed if it did not return; with the feedback
  // `stopped` if `products` stopped it.
  MessageReader ask(
      const MessageWriter& request, const Products& products,
      const std::string& stopped = "takes more products with the matrix than the step limit allows");

  // The reply in an answer; throws CaseFailed as above if there is none.
  MessageReader reply_of(Answer answer, const std::string& stopped = {}) const;

  // Describes the following cases for staff: "tridiagonal, n = 10".
  void describe(const std::string& text) { description_ = text; }

  void expect(bool holds, const std::string& feedback, const std::string& detail = {}) const;

  // error <= bound; otherwise the student reads "<what> is 10 to 1000 times as large as allowed". NaN fails.
  void expect_at_most(double error, double bound, const std::string& what,
                      const std::string& detail = {}) const;

  [[noreturn]] void fail(Status status, const std::string& feedback, const std::string& detail) const;

  Random random;

 private:
  Student& student_;
  std::string description_;
};

struct Category {
  std::string name;   // in the suite's own output: "Examples"
  std::string title;  // for students: "The lecture's examples"
  double weight;      // relative: an exercise's points are distributed by these weights
  std::function<void(Trial&)> run;
};

// The ratio of error and bound, in bands: an exact number could reveal a hidden case's value.
std::string band(double error, double bound);

}  // namespace grader

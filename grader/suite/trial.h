// STAFF ONLY. A category of an exercise's hidden cases, and what its code has at hand. The first case that
// fails ends its category.
//
// A failure has two readers. The student is told which property is missing, and the size of an error in
// bands; staff see inputs, expected and actual values.
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

  // What the student's function returned. Throws CaseFailed if it did not return; with the feedback `stopped` if
  // `products` had enough.
  MessageReader ask(
      const MessageWriter& request, const Student::Products& products,
      const std::string& stopped = "takes more products with the matrix than the step limit allows");

  // The reply of an answer; throws CaseFailed as above if it is none.
  MessageReader reply_of(Answer answer, const std::string& stopped = {}) const;

  // What the cases from here on try, for staff: "tridiagonal, n = 10".
  void describe(const std::string& text) { description_ = text; }

  void expect(bool holds, const std::string& feedback, const std::string& detail = {}) const;

  // error <= bound, or the student reads "<what> is 10 to 1000 times as large as allowed". NaN fails.
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
  double weight;      // in points of an exercise whose points are the weights' sum
  std::function<void(Trial&)> run;
};

// How many times the bound an error is, in bands: an exact figure would be a hidden case's value in disguise.
std::string band(double error, double bound);

}  // namespace grader

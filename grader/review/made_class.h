// STAFF ONLY. For tests: results and whole classes that nobody graded.
#pragma once

#include <string>
#include <vector>

#include "grader/record/record.h"

namespace grader::inline review {

// This is a category that is lost, counted from 1, by so many times its limit; 0: without a number.
struct Loss {
  std::size_t category = 1;
  double times = 0;
  Status status = Status::wrong;
};

// This has eight categories of two points, the last one a whole run.
ExerciseResult made_exercise(const std::string& id, const std::vector<Loss>& losses = {});
ExerciseResult with_picture(ExerciseResult exercise, double flip, bool far_off);  // without its bytes
SubmissionResult made_result(const std::string& name, std::vector<ExerciseResult> exercises);

// This is a case that a TA should find: its item's key, and what is right.
struct Planted {
  std::string key, right;
};

// Puts a class of fourteen exercises into an empty record, in six sections: most people have ordinary
// mistakes, and some are planted. `size` is 30 at least.
std::vector<Planted> put_made_class(Record& record, std::size_t size = 180);

}  // namespace grader::review

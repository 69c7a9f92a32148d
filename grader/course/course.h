// STAFF ONLY. A course as the grader has it: the exercises (hair/course/course.h), and from the course file
// the limits on a submission (budget.h), and "partial": a category then gives points for the share of its
// cases that hold, and all or nothing without it. Both may be missing:
//
//   {"exercises": {"S2": {"role": "optional", "points": 5}}, "budget": {"idle_seconds": 10}, "partial": true}
#pragma once

#include "grader/course/budget.h"
#include "hair/course/course.h"

namespace grader::inline course {

using hair::Exercise, hair::Role, hair::to_string;

// True if students hand such exercises in.
inline bool is_asked_for(Role role) {
  return role == Role::assigned || role == Role::optional;
}

// Starts at the project's root.
inline std::filesystem::path solution_of(const Exercise& exercise) {
  return std::filesystem::path("reference") / exercise.id / exercise.file;
}
inline std::filesystem::path unwritten_file_of(const Exercise& exercise) {
  return std::filesystem::path("handout") / exercise.folder / exercise.file;
}

struct Course : hair::Course {
  Budget budget = {};                        // limits a submission
  bool partial = false;                      // a category gives a share of its points, in whole ones
  std::vector<std::string> of_hand_in = {};  // are the exercises of the graded hand-in; empty: all

  // True for an exercise that students hand in, in the graded hand-in.
  bool asks_for(const Exercise& exercise) const;
};

// Throws BadInput with the file and the JSON path.
Course read_course(const std::filesystem::path& exercises_json,
                   const std::optional<std::filesystem::path>& course_json = {});

}  // namespace grader::course

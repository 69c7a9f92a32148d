// STAFF ONLY. The exercises of a course: handout/exercises.json, with the changes of an instructor's course
// file.
//
// A course file changes the role or the points of exercises, and what a submission may take of the machine
// (budget.h), and whether a category gives points for the share of its cases that hold ("partial": all or nothing without it). What
// it leaves out keeps its value; "budget" and "partial" may be missing:
//
//   {"exercises": {"S1": {"role": "given"}, "S2": {"role": "optional", "points": 5}},
//    "budget": {"idle_seconds": 10}, "partial": true}
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/budget.h"

namespace grader {

// assigned: counts. optional: extra credit, added on top of the total. given: handed out solved. absent: left
// out.
enum class Role { assigned, optional, given, absent };

struct Exercise {
  std::string id;                          // "S1"
  std::string title;                       // "Conjugate gradients"
  std::string file;                        // "conj_grad.cpp"
  std::vector<std::string> functions;      // defined in the file, demangled: "ConjGrad(int, ...)"
  std::string header;                      // the header with their contract, relative to the project's root
  std::string text;                        // the assignment text, relative to handout/
  std::string checks;                      // the public checks, relative to handout/
  std::vector<std::string> prerequisites;  // ids of exercises whose functions it calls
  std::vector<std::string> libraries;      // allowed besides the standard library: "eigen"
  double points = 0;
  Role role = Role::assigned;
};

struct Course {
  std::vector<Exercise> exercises;  // in the order of exercises.json, absent ones included
  Budget budget = {};               // of a submission
  bool partial = false;             // a category gives a share of its points, in whole ones

  const Exercise* find(const std::string& id) const;  // null if there is none
};

// Throws BadInput with the file and the JSON path.
Course read_course(const std::filesystem::path& exercises_json,
                   const std::optional<std::filesystem::path>& course_json = {});

std::string to_string(Role role);

}  // namespace grader

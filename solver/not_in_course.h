// The exception that a function throws if its exercise is not in the course. The build generates such
// functions from exercises.json (hair_left_out in cmake/exercises.cmake), so that all given code links in
// every course.
#pragma once

#include <stdexcept>
#include <string>

class NotInCourse : public std::logic_error {
 public:
  // `what` is the exercise's id and the function's name, as in "H3 add_bend_force".
  explicit NotInCourse(const std::string& what) : std::logic_error(what + " is not in this course") {}
};

// The exception of a function whose exercise the course leaves out. Definitions that throw it are generated
// from exercises.json (hair_left_out in cmake/exercises.cmake), so that all given code is linked in every
// course.
#pragma once

#include <stdexcept>
#include <string>

class NotInCourse : public std::logic_error {
 public:
  // `what` is the exercise's id and the function's name, as in "H3 add_bend_force".
  explicit NotInCourse(const std::string& what) : std::logic_error(what + " is not in this course") {}
};

// The list of exercises in this course. The build takes it from exercises.json: hair_knows_course in
// handout/cmake/exercises.cmake defines HAIR_COURSE for the code that includes this header.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace hair {

// The position of the exercise in the course's order; npos if the course leaves it out.
constexpr std::size_t place_in_course(std::string_view id) {
  constexpr std::string_view course = HAIR_COURSE;  // " S1 S2 "
  for (std::size_t at = course.find(id); at != course.npos; at = course.find(id, at + 1))
    if (course[at - 1] == ' ' && course[at + id.size()] == ' ') return at;
  return std::string_view::npos;
}

// `if constexpr (in_course("H3"))` leaves out calls of an exercise that is not linked.
constexpr bool in_course(std::string_view id) {
  return place_in_course(id) != std::string_view::npos;
}

// Throws std::invalid_argument if `what` needs an exercise that this course leaves out.
inline void require_exercise(const std::string& what, const std::string& id) {
  if (!in_course(id))
    throw std::invalid_argument(what + " needs exercise " + id + ", which this course leaves out");
}

}  // namespace hair

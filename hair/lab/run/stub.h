// Names the exercises that a scene needs but that are still stubs.
#pragma once

#include <string>
#include <string_view>

#include "hair/course/course.h"
#include "hair/io/files/printable.h"
#include "solver/not_implemented.h"

namespace hair {

// The functions of this program's exercises that are stubs, a line each: "H1 stretch_energy". Each program
// has its own, which the build makes of the exercises' files (stubs.cmake).
extern const char* const kStubs;

// Sets `stub` of each exercise that has all of its functions in such a list.
void mark_stubs(Course& course, std::string_view stubs);

// "S1 (student/conj_grad.cpp), H1 (student/stretch_springs.cpp)": those of `ids` that are stubs; empty if
// there are none.
std::string stubs_among(const std::vector<std::string>& ids, const Course& course);

// "H2: student/angular_springs.cpp, bend_energy is not implemented yet"
std::string missing_part(const std::string& what);  // `what` of a stub, printable
inline std::string missing_part(const NotImplemented& stub) {
  return missing_part(printable(stub.what()));
}

// The same for the stub that a run stopped at; then those of the other exercises that it calls (`ids`): "...;
// nor are S1 (student/conj_grad.cpp), H4 (student/implicit_euler.cpp)".
std::string missing_parts(const NotImplemented& stub, std::vector<std::string> ids, const Course& course);

}  // namespace hair

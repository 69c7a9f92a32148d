// Names the exercise that a scene needs but that is still a stub.
#pragma once

#include <string>

#include "hair/io/files/printable.h"
#include "solver/not_implemented.h"

namespace hair {

// "H2: student/angular_springs.cpp, bend_energy is not implemented yet"
std::string missing_part(const std::string& what);  // `what` of a stub, printable
inline std::string missing_part(const NotImplemented& stub) {
  return missing_part(printable(stub.what()));
}

}  // namespace hair

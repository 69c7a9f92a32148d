// What a scene still misses of the exercises that it calls.
#pragma once

#include <string>

#include "hair/io/files/printable.h"
#include "solver/not_implemented.h"

namespace hair {

// "H2: student/angular_springs.cpp, bend_energy is not implemented yet"
std::string missing_part(const std::string& what);  // of a stub, printable
inline std::string missing_part(const NotImplemented& stub) {
  return missing_part(printable(stub.what()));
}

}  // namespace hair

// What measured: times mean nothing without it.
#pragma once

#include <string>

namespace hair {

struct Machine {
  std::string processor;  // "AMD EPYC 9654 96-Core Processor"
  int cores = 0;          // that the system has
  std::string compiler;   // "GCC 12.2.0"
  std::string build;      // "Release, -O3 -DNDEBUG; ... -O3"
  std::string eigen;      // "3.4.0"

  bool operator==(const Machine&) const = default;
};

Machine this_machine();

// For a page: "Measured on ..., 2 cores, one of them used; GCC ...".
std::string measured_on(const Machine& machine);

// Of the bytes of the program that runs, with all that was linked into it; where the system has no way to read them,
// "unknown".
std::string program_digest();

}  // namespace hair

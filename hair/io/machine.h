// The machine and the build of a measurement: times mean nothing without them.
#pragma once

#include <string>

namespace hair {

struct Machine {
  std::string processor;  // "AMD EPYC 9654 96-Core Processor"
  int cores = 0;          // the machine's cores
  std::string compiler;   // "GCC 12.2.0"
  std::string build;      // "Release, -O3 -DNDEBUG; ... -O3"
  std::string eigen;      // "3.4.0"

  bool operator==(const Machine&) const = default;
};

Machine this_machine();

// A text for a page: "Measured on ..., 2 cores, one of them used; GCC ...".
std::string measured_on(const Machine& machine);

}  // namespace hair

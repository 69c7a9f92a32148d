#include "hair/io/machine.h"

#include <Eigen/Core>
#include <fstream>
#include <thread>

#include "hair/io/files/printable.h"

namespace hair {

namespace {

// The name that Linux gives in a line "model name : ...".
std::string processor() {
  std::ifstream lines("/proc/cpuinfo");
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(':');
    const std::size_t begin = colon == std::string::npos ? colon : line.find_first_not_of(" \t", colon + 1);
    if (begin != std::string::npos) return printable(line.substr(begin));
  }
  return "unknown processor";
}

std::string compiler() {
#if defined(__clang__)
  return std::string("Clang ") + __clang_version__;
#elif defined(__GNUC__)
  return std::string("GCC ") + __VERSION__;
#else
  return "unknown compiler";
#endif
}

}  // namespace

Machine this_machine() {
  return {processor(), static_cast<int>(std::thread::hardware_concurrency()), compiler(), HAIR_BUILD,
          std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
              std::to_string(EIGEN_MINOR_VERSION)};
}

std::string measured_on(const Machine& machine) {
  return "Measured on " + machine.processor + ", " + std::to_string(machine.cores) +
         " cores, one of them used; " + machine.compiler + ", " + machine.build + "; Eigen " + machine.eigen +
         ".";
}

}  // namespace hair

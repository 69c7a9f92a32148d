#include "hair/io/files/this_program.h"

#ifdef __APPLE__
#include <mach-o/dyld.h>

#include <array>
#endif

namespace hair {

std::filesystem::path this_program() {
#ifdef __APPLE__
  std::array<char, 4096> path;
  uint32_t size = path.size();
  if (_NSGetExecutablePath(path.data(), &size) == 0) return path.data();
#endif
  return "/proc/self/exe";
}

}  // namespace hair

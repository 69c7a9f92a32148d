#include "hair/io/files/cache_folder.h"

#include <cstdlib>

namespace hair {

std::optional<std::filesystem::path> cache_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::filesystem::path(value ? value : "");
  };
  if (const auto folder = variable("XDG_CACHE_HOME"); folder.is_absolute()) return folder / "hairlab";
  if (const auto home = variable("HOME"); home.is_absolute()) return home / ".cache" / "hairlab";
  return {};
}

}  // namespace hair

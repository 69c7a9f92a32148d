// STAFF ONLY. Recognises files of operating systems.
#include "grader/intake/names/ignored.h"

#include <algorithm>
#include <array>

namespace grader::inline intake {

bool is_ignored(std::string_view path) {
  // These are Macs' resource forks, icons and indices; Windows' thumbnails, zones and Office's locks;
  // Synology's indices.
  constexpr std::array<std::string_view, 7> kNames{"__MACOSX", "Thumbs.db", "ehthumbs.db", "desktop.ini",
                                                   "Icon\r",   "@eaDir",    "#recycle"};
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('/'));
    if (part.starts_with('.') || part.starts_with("~$") || part.ends_with(":Zone.Identifier") ||
        std::ranges::find(kNames, part) != kNames.end())
      return true;
    path.remove_prefix(std::min(part.size() + 1, path.size()));
  }
  return false;
}

}  // namespace grader::intake

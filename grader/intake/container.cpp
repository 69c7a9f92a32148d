// STAFF ONLY.
#include "grader/intake/container.h"

#include <utility>

namespace grader {

Entry entry_at(std::string shown) {
  Entry entry;
  entry.leads_outside = !shown.empty() && (shown.front() == '/' || shown.front() == '\\');
  std::string_view rest = shown;
  while (!rest.empty()) {
    const std::size_t end = rest.find_first_of("/\\");
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    const bool drive = entry.path.empty() && part.size() == 2 && part[1] == ':';
    if (part == ".." || drive) {
      entry.leads_outside = true;
    } else if (!part.empty() && part != ".") {
      entry.path += (entry.path.empty() ? "" : "/") + std::string(part);
    }
  }
  entry.shown = std::move(shown);
  return entry;
}

std::string_view name_of(const Entry& entry) {
  const std::string_view path = entry.path;
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string shown_size(std::uintmax_t bytes) {
  constexpr std::uintmax_t mebibyte = 1 << 20;
  if (bytes >= mebibyte) return std::to_string(bytes / mebibyte) + " MiB";
  return std::to_string(bytes) + " bytes";
}

}  // namespace grader

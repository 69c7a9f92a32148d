// STAFF ONLY.
#include "grader/intake/names.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "grader/intake/archive_format.h"

namespace grader {

std::string submission_name(std::string_view name) {
  constexpr std::size_t longest = 150;
  constexpr std::array<std::string_view, 7> taken{"staff",       "grades.csv", "index.html",  "junit.xml",
                                                  "timing.json", "costs.html", "made-by.json"};
  std::string safe(without_archive_ending(name).substr(0, longest));
  for (char& c : safe) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '_' || c == '-';
    if (!plain) c = '_';
  }
  if (safe.empty() || std::string_view("-_.").find(safe.front()) != std::string_view::npos)
    safe.insert(0, "x");
  if (safe.starts_with("class.sqlite") || std::find(taken.begin(), taken.end(), safe) != taken.end())
    safe += '_';
  return safe;
}

std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) list += (i > 0 ? ", " : "") + names[i];
  return list + (names.size() > kMost ? " and " + std::to_string(names.size() - kMost) + " more" : "");
}

std::string name_among_equals(const std::string& name, std::string_view path) {
  constexpr char digits[] = "0123456789abcdef";
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : path) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  hash ^= hash >> 32;
  std::string result = name + "-";
  for (int shift = 28; shift >= 0; shift -= 4) result += digits[hash >> shift & 15];
  return result;
}

}  // namespace grader

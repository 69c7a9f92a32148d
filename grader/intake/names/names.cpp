// STAFF ONLY. Makes safe names of submissions.
#include "grader/intake/names/names.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "grader/intake/names/archive_format.h"
#include "grader/text/letters.h"

namespace grader::inline intake {

std::string submission_name(std::string_view name) {
  constexpr std::size_t longest = 150;
  constexpr std::array<std::string_view, 8> taken{"staff",        "grades.csv",    "index.html",
                                                  "junit.xml",    "timing.json",   "costs.html",
                                                  "made-by.json", "left-over.json"};
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

std::string name_of_owner(const Owner& owner) {
  constexpr std::size_t kLongestName = 80, kLongestId = 60;
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  std::string name = without_marks(owner.name);
  const bool lost = !std::ranges::all_of(name, is_ascii);
  if (lost && !owner.id.empty()) std::erase_if(name, [&](char c) { return !is_ascii(c); });
  if (owner.anonymous && !owner.id.empty() && name.empty()) name = "anon";
  std::string id = owner.id;
  if (id.size() > kLongestId) id = name_among_equals(id.substr(0, kLongestId), id);
  if (!id.empty() && name.size() > kLongestName) name.resize(kLongestName);
  while (!id.empty() && !name.empty() && name.back() == ' ') name.pop_back();
  if (!name.empty() && !id.empty()) name += '_';
  const std::string safe = submission_name(name + id);
  return lost && owner.id.empty() ? name_among_equals(safe, owner.name) : safe;
}

std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) list += (i > 0 ? ", " : "") + names[i];
  return list + (names.size() > kMost ? " and " + std::to_string(names.size() - kMost) + " more" : "");
}

std::string name_among_equals(const std::string& name, std::string_view path) {
  constexpr char digits[] = "0123456789abcdef";
  std::uint64_t hash = 0xcbf29ce484222325;  // is FNV-1a
  for (const char c : path) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  hash ^= hash >> 32;
  std::string result = name + "-";
  for (int shift = 28; shift >= 0; shift -= 4) result += digits[hash >> shift & 15];
  return result;
}

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

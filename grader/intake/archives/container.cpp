// STAFF ONLY. Cleans the paths of entries.
#include "grader/intake/archives/container.h"

#include <algorithm>
#include <map>
#include <utility>

#include "grader/intake/names/code_page.h"
#include "grader/intake/names/names.h"
#include "grader/text/letters.h"

namespace grader::inline intake {

Entry entry_at(std::string shown) {
  Entry entry;
  entry.lost_root = !shown.empty() && (shown.front() == '/' || shown.front() == '\\');
  std::vector<std::string_view> parts;
  std::string_view rest = shown;
  while (!rest.empty()) {
    const std::size_t end = rest.find_first_of("/\\");
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    const bool drive = parts.empty() && part.size() == 2 && part[1] == ':';
    if (drive || (part == ".." && parts.empty())) {
      entry.lost_root = true;
    } else if (part == "..") {
      entry.leads_outside = true;
    } else if (!part.empty() && part != ".") {
      parts.push_back(part);
    }
  }
  const bool of_all_users = parts.size() > 2 && (parts[0] == "Users" || parts[0] == "home");
  for (std::size_t i = entry.lost_root && of_all_users ? 1 : 0; i < parts.size(); ++i)
    entry.path += (entry.path.empty() ? "" : "/") + std::string(parts[i]);
  entry.shown = std::move(shown);
  return entry;
}

namespace {

// Replaces each part of the path that is too long for file systems, or takes more than linear time to
// compose, by a number.
std::string within_limits(std::string_view path) {
  constexpr std::size_t kLongestPart = 255;
  std::string result;
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find_first_of("/\\"));
    result += part.size() <= kLongestPart && is_stream_safe(part) ? part : name_among_equals("name", part);
    path.remove_prefix(part.size());
    result += path.substr(0, 1);
    path.remove_prefix(std::min<std::size_t>(path.size(), 1));
  }
  return result;
}

}  // namespace

std::vector<std::string> settle_names(std::vector<Entry>& list, const std::string& shown) {
  std::vector<std::string> names, said;
  for (const Entry& entry : list) names.push_back(entry.shown);
  if (const std::string page = decode_names(names); !page.empty())
    said.push_back(shown + ": names in it are no UTF-8; they were read as " + page + ", which is a guess");
  const Entry *first_root = nullptr, *first_refused = nullptr;
  std::size_t roots = 0, refused = 0;
  std::map<std::string_view, Entry*> last;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string limited = within_limits(names[i]);
    const Entry named = entry_at(composed_path(limited));
    Entry& entry = list[i];
    if (limited != names[i] && refused++ == 0) first_refused = &entry;
    entry.shown = named.shown;
    entry.path = named.path;
    entry.leads_outside = named.leads_outside;
    entry.lost_root = named.lost_root;
    if (entry.kind == Entry::Kind::folder) continue;
    if (entry.path.empty()) entry.path = entry.shown = "entry " + std::to_string(i + 1);
    if (entry.lost_root && roots++ == 0) first_root = &entry;
    Entry*& latest = last[entry.path];
    if (latest) latest->replaced = true;
    latest = &entry;
  }
  const auto and_more = [](std::size_t count) {
    return count > 1 ? ", as in " + std::to_string(count - 1) + " more" : "";
  };
  if (refused > 0)
    said.push_back(shown +
                   ": a name of more than 255 bytes, or with more than 30 marks in a row, is refused: " +
                   legible(first_refused->shown) + " stands for it" + and_more(refused));
  if (roots > 0)
    said.push_back(shown + ": " + legible(first_root->shown) + " begins at a root, which was left away" +
                   and_more(roots));
  return said;
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

}  // namespace grader::intake

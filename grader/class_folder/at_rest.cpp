// STAFF ONLY. Reads modes of files and of the folders above them.
#include "grader/class_folder/at_rest.h"

#include <algorithm>
#include <system_error>

#include "grader/course/input.h"
#include "grader/text/shell_word.h"

namespace grader::inline class_folder {
namespace {

namespace fs = std::filesystem;

bool lets_others(const fs::path& path, fs::perms right) {
  std::error_code error;
  return (fs::status(path, error).permissions() & right) != fs::perms::none && !error;
}

bool others_can_read(const fs::path& place) {
  std::error_code error;
  const fs::path real = fs::canonical(place, error);
  if (error) return false;
  // Other users who may enter a folder can open each file whose name they know.
  if (!lets_others(real, fs::is_directory(real, error) ? fs::perms::others_exec : fs::perms::others_read))
    return false;
  for (fs::path above = real.parent_path(); above != above.root_path(); above = above.parent_path())
    if (!lets_others(above, fs::perms::others_exec)) return false;
  return true;
}

}  // namespace

std::string readable_by_others(const std::vector<StaffPlace>& places) {
  std::string names, command;
  std::vector<fs::path> tops;
  for (const StaffPlace& place : places) {
    if (!others_can_read(place.path)) continue;
    names += (names.empty() ? "" : ", ") + place.name;
    if (std::find(tops.begin(), tops.end(), place.top) != tops.end()) continue;
    tops.push_back(place.top);
    command += " " + shell_word(printable(place.top.string(), 4096));
  }
  if (names.empty()) return {};
  return "others on this machine can read " + names + "; this keeps them out: chmod go=" + command;
}

}  // namespace grader::class_folder

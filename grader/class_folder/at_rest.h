// STAFF ONLY. Tests if other users of this machine can read the staff's files where they lie between two
// runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader::inline class_folder {

struct StaffPlace {
  std::string name;            // "the secret"
  std::filesystem::path path;  // is a file or a folder; may be missing
  std::filesystem::path top;   // is a folder above it that only the staff uses, or the place itself
};

// Returns a sentence that names the places that others can read, with the command that shuts them out; or an
// empty one. A place counts if its own mode and that of each folder above let others in: links are followed,
// lists of access are not read, and the staff has chosen a group's members.
std::string readable_by_others(const std::vector<StaffPlace>& places);

}  // namespace grader::class_folder

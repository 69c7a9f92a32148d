// STAFF ONLY. Looks whether other users of this machine can read what students must not see, where it lies
// between two runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader::inline tool {

struct StaffPlace {
  std::string name;            // "the secret"
  std::filesystem::path path;  // a file or a folder; may be missing
  std::filesystem::path top;   // a folder above it that is the staff's as a whole, or the place itself
};

// A sentence that names the places that others can read, with the command that shuts them out; empty if there
// are none. A place counts if its own mode and that of each folder above let others in: links are followed,
// lists of access are not read, and a group is whom the staff chose.
std::string readable_by_others(const std::vector<StaffPlace>& places);

}  // namespace grader::tool

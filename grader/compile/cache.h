// STAFF ONLY. Files that are kept from one run to the next.
#pragma once

#include <filesystem>

namespace grader {

// Copies a file to where others may read it at any time: under another name first. What can't be kept is not.
void keep_copy(const std::filesystem::path& file, const std::filesystem::path& kept);

}  // namespace grader

// STAFF ONLY. A file cache between runs.
#pragma once

#include <filesystem>

namespace grader {

// Copies a file into a cache that others may read at any time: first under another name. Ignores failures.
void keep_copy(const std::filesystem::path& file, const std::filesystem::path& kept);

}  // namespace grader

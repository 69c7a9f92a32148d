// Files appear whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace hair {

// Writes to a temporary name beside `file` and renames. Makes missing folders. If anything fails, the
// temporary file is removed, an earlier `file` stays as it was, and BadInput says which path and why. Several may
// write the same file: one of them comes last.
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace hair

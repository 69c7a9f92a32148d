// Writes files atomically: the whole file appears, or nothing.
#pragma once

#include <filesystem>
#include <string_view>

namespace hair {

// Writes to a temporary name next to `file` and renames it. Makes missing folders. If anything fails, removes
// the temporary file, leaves an earlier `file` unchanged, and throws BadInput with the path and the reason.
// Several processes may write the same file: the last one wins.
void write_file(const std::filesystem::path& file, std::string_view bytes);

// For a file that a user named, before the work starts: throws BadInput if the file's folder does not exist.
// Otherwise a slip in the name would make another folder.
void check_folder_of(const std::filesystem::path& file);

}  // namespace hair

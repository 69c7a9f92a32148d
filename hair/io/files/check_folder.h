// Files that a user named.
#pragma once

#include <filesystem>

namespace hair {

// Before there is work: throws BadInput if the file's folder is not there. A slip in a name would make another folder.
void check_folder_of(const std::filesystem::path& file);

}  // namespace hair

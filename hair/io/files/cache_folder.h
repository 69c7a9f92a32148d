// The folder in which programs keep results that take long to make.
#pragma once

#include <filesystem>
#include <optional>

namespace hair {

// $XDG_CACHE_HOME/hairlab, or ~/.cache/hairlab. Nothing if neither variable is an absolute path. The folder
// may not exist yet.
std::optional<std::filesystem::path> cache_folder();

}  // namespace hair

// The folder in which programs keep what takes long to make.
#pragma once

#include <filesystem>
#include <optional>

namespace hair {

// $XDG_CACHE_HOME/hairlab, or ~/.cache/hairlab. Nothing if neither variable is an absolute path. It may not
// be there yet.
std::optional<std::filesystem::path> cache_folder();

}  // namespace hair

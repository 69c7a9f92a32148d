// Keeps results that cost much to compute for later runs: a folder with one file for each. A file contains
// its full key and ends with a digest of itself. A file with another key, or one that is cut short or
// changed, is ignored.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hair {

struct KeptKind {
  std::string_view says;    // the first line of a file: "hairlab: an accurate motion, format 1"
  std::string_view ending;  // the file's extension
};

// The content kept under this key, which is one line; nothing if there is none, or if the file is not valid.
std::optional<std::string> find_kept(const std::filesystem::path& folder, const KeptKind& kind,
                                     std::string_view key);

// Throws BadInput if the folder can't be written.
void keep(const std::filesystem::path& folder, const KeptKind& kind, std::string_view key,
          std::string_view content);

// $XDG_CACHE_HOME/hairlab, or ~/.cache/hairlab. Nothing if neither variable is an absolute path. The folder
// may not exist yet.
std::optional<std::filesystem::path> cache_folder();

}  // namespace hair

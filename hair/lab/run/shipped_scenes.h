// The scenes that come with the project, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hair {

// Their names in alphabetical order: "bead-on-wire", ..., from the *.json files in the folder.
std::vector<std::string> shipped_scenes(const std::filesystem::path& folder);

// The path of `scene`: a file, or the name of a shipped scene. Throws BadInput with a list of the shipped
// scenes.
std::filesystem::path find_scene(const std::string& scene, const std::filesystem::path& folder);

}  // namespace hair

// The scenes that come with the project, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hair {

// Their names, in order: "bead-on-wire", ... of the *.json in the folder.
std::vector<std::string> shipped_scenes(const std::filesystem::path& folder);

// What a person means by `scene`: a file, or the name of a shipped one. Throws BadInput, which lists those
// that ship.
std::filesystem::path find_scene(const std::string& scene, const std::filesystem::path& folder);

}  // namespace hair

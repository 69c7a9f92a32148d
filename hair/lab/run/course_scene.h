// The scene that a command names, if its exercises are in the course.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hair/course/course.h"
#include "hair/scene/scene.h"

namespace hair {

// The names of the scenes that come with the project, in alphabetical order: "bead-on-wire", ..., from the
// *.json files in the folder.
std::vector<std::string> shipped_scenes(const std::filesystem::path& folder);

// The path of `scene`: a file, or the name of a shipped scene. Throws BadInput with a list of the shipped
// scenes.
std::filesystem::path find_scene(const std::string& scene, const std::filesystem::path& folder);

// `name`: a file, or the name of a shipped scene. Throws BadInput for a scene that can't be read, and for one
// that calls an exercise that is not in the course.
Scene read_course_scene(const std::string& name, const Course& course);

// The same for a scene that is not run: with few of its strands.
Scene read_course_outline(const std::string& name, const Course& course);

}  // namespace hair

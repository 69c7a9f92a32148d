// STAFF ONLY. Commands in the handout's texts that play a scene, where the course lacks the scene.
#pragma once

#include <string>

#include "grader/package/gates.h"

namespace grader::inline package {

// A text, Markdown, whose commands play only scenes that are there. `missing` has what ships in other courses
// only, "given/hair/scenes/wind.json". In a block of code a command has another scene in the place of an
// example's, or it goes; so does a block that is left empty. A paragraph or item of a list that plays a
// missing scene, says "look at" or "study" it, or copies its file becomes a sentence that the course lacks
// it.
std::string with_present_scenes(const std::string& text, const Paths& shipped, const Paths& missing);

}  // namespace grader::package

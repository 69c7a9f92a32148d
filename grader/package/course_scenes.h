// STAFF ONLY. Changes commands in the handout's texts whose scene the course lacks.
#pragma once

#include <string>

#include "grader/package/gates.h"

namespace grader::inline package {

// Returns a text, Markdown, whose commands run only scenes that ship. `missing` lists scenes of other
// courses, "given/hair/scenes/wind.json". In a block of code a command gets another scene in the place of an
// example's, or it is removed; so is a block that becomes empty. A paragraph or item of a list that runs a
// missing scene, says "look at" or "study" it, or copies its file becomes a sentence that the course lacks
// it.
std::string with_present_scenes(const std::string& text, const Paths& shipped, const Paths& missing);

}  // namespace grader::package

// STAFF ONLY. Scenes as texts, and the errors of reading them.
#pragma once

#include <string>

#include "hair/scene/scene.h"

namespace reference_tests {

// A small valid scene, with the first `what` in its text replaced by `by`.
std::string small_scene(const std::string& what = "", const std::string& by = "");

// Two rows of linked hair.
std::string linked_scene();

// The message of the BadInput for the text as "a.json"; empty if there is none.
std::string complaint(const std::string& text);

}  // namespace reference_tests

// STAFF ONLY. Scenes as texts, and what is said of them.
#pragma once

#include <string>

#include "hair/scene/scene.h"

namespace reference_tests {

// A small scene that is right, with the first `what` in its text replaced by `by`.
std::string small_scene(const std::string& what = "", const std::string& by = "");

// The BadInput that reading the text as "a.json" throws; empty if none.
std::string complaint(const std::string& text);

}  // namespace reference_tests

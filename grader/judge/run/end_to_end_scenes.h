// STAFF ONLY. Small scenes that run end to end through all exercises and show whether they work together.
// Each takes the reference a few milliseconds.
#pragma once

#include <string>
#include <vector>

namespace grader {

struct SceneText {
  std::string name;  // "strand-swing"
  std::string json;  // in the format of hair/scenes/README.md
};

const std::vector<SceneText>& end_to_end_scenes();

}  // namespace grader

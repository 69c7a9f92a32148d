// STAFF ONLY. Small scenes that run end to end through all exercises: what they show is whether everything
// fits together. Each takes the reference a few milliseconds.
#pragma once

#include <string>
#include <vector>

namespace grader {

struct SceneText {
  std::string name;  // "strand-swing"
  std::string json;  // as hair/scenes/README.md has it
};

const std::vector<SceneText>& end_to_end_scenes();

}  // namespace grader

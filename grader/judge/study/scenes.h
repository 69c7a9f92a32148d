// STAFF ONLY. The small scenes of a study, which all exercises of a submission run together. Each takes the
// reference a few milliseconds.
#pragma once

#include <string>
#include <vector>

namespace grader::inline judge {

struct SceneText {
  std::string name;  // "strand-swing"
  std::string json;  // in the format of hair/scenes/README.md
};

const std::vector<SceneText>& studied_scenes();

}  // namespace grader::judge

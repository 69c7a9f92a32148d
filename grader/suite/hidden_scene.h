// STAFF ONLY. The scene of an exercise's whole run: grader/suite/H1/scene.json for H1, varied a little by a seed,
// so that nobody knows where it ends. The seed is the same for a class, whose pictures can then be compared.
//
//   {"canary": "STAFF ONLY: ...",
//    "scene": SCENE,                              as hair/scenes/README.md describes it
//    "vary": {"/toys/0/start/2/x": 0.05, ...},    numbers of SCENE, and by how much at most they are moved
//    "pictures": [10, 20, 30]}                    frames that are drawn
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hair/scene/scene.h"

namespace grader {

struct HiddenScene {
  std::string text;  // what a worker gets
  hair::Scene scene;
  std::vector<int> pictures;
};

// Throws BadInput for a file that is not of that form.
HiddenScene read_hidden_scene(const std::filesystem::path& file, const std::string& seed);

}  // namespace grader

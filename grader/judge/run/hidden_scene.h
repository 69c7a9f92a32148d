// STAFF ONLY. The scene of an exercise's whole run: reference/H1/scene.json for H1, with small variations
// by a seed, so that its result is not predictable. The seed is the same for a class, so that pictures can be
// compared.
//
//   {"canary": "STAFF ONLY: ...",
//    "scene": SCENE,                              as hair/scenes/README.md describes it
//    "vary": {"/toys/0/start/2/x": 0.05, ...},    numbers of SCENE, with the largest variation of each
//    "pictures": [10, 20, 30]}                    frames to draw
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hair/scene/scene.h"

namespace grader::inline judge {

struct HiddenScene {
  std::string text;  // is sent to the worker
  hair::Scene scene;
  std::vector<int> pictures;
};

// Throws BadInput for a file in another format.
HiddenScene read_hidden_scene(const std::filesystem::path& file, const std::string& seed);

}  // namespace grader::judge

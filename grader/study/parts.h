// STAFF ONLY. What a study plays: each end-to-end scene, toy by toy where it has some, with fewer and with more steps.
#pragma once

#include <string>
#include <vector>

#include "grader/suite/end_to_end_scenes.h"
#include "hair/scene/scene.h"

namespace grader {

struct StudiedPart {
  std::string name;   // "pendulums, forward Euler"
  std::string json;   // a scene with nothing else in it
  hair::Scene scene;  // of that text
  int order = 1;      // of its method, where the motion is smooth
};

std::vector<StudiedPart> parts_of(const SceneText& text);

// The same motion in other steps: `frames` of them are seen, after the start.
struct Division {
  int frames = 1, steps_per_frame = 1;
  int steps() const { return frames * steps_per_frame; }
};
SceneText divided(const StudiedPart& part, const Division& division);

// From a few steps to many, by powers of two around the scene's own.
std::vector<Division> divisions_of(const hair::Scene& scene);

// Between two divisions of which one has twice the other's steps: those that there are between the two, fewest first.
std::vector<Division> between(const Division& coarse);

}  // namespace grader

// STAFF ONLY. The small scenes of a study, which all exercises of a submission run together, each in a few
// milliseconds of the reference; and their parts: a scene, or one of its toys, in fewer or more steps.
#pragma once

#include <string>
#include <vector>

#include "hair/scene/scene.h"

namespace grader::inline judge {

struct SceneText {
  std::string name;  // "strand-swing"
  std::string json;  // in the format of hair/scenes/README.md
};

const std::vector<SceneText>& studied_scenes();

struct StudiedPart {
  std::string name;   // "pendulums, forward Euler"
  std::string json;   // a scene with only this part
  hair::Scene scene;  // parsed from that text
  int order = 1;      // is the order of its method, for smooth motions
};

std::vector<StudiedPart> parts_of(const SceneText& text);

// Describes the same motion with other steps; `frames` frames are recorded after the start.
struct TimeGrid {
  int frames = 1, steps_per_frame = 1;
  int steps() const { return frames * steps_per_frame; }
};
SceneText on_grid(const StudiedPart& part, const TimeGrid& grid);

// Lists grids from few steps to many, by powers of two around the scene's own number.
std::vector<TimeGrid> grids_of(const hair::Scene& scene);

// Lists the grids between `coarse` and the one with twice its steps, fewest steps first.
std::vector<TimeGrid> between(const TimeGrid& coarse);

}  // namespace grader::judge

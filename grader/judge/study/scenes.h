// STAFF ONLY. The small scenes of a study, which all exercises of a submission run together, each in a few
// milliseconds of the reference; their parts: a scene, or one of its toys, in fewer or more steps; and each
// part's true motion.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hair/scene/scene.h"
#include "hair/truth/accurate_motion.h"

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

// Holds the reference solution of a part's motion, against which errors are measured. It is the same for a
// class, and is stored.
struct Truth {
  hair::AccurateMotion motion;  // its states are the frames of the part's scene; the first is the start
  double size = 0;              // m: the diagonal of the motion's bounding box
};

// The accurate solution of the equations of motion if there is one (hair/truth/accurate_motion.h). Otherwise
// (several strands, or hair with obstacles) the reference itself, with many times the steps of the finest
// division. `kept` is a folder for stored motions. Throws std::runtime_error if the reference breaks.
Truth true_motion(const StudiedPart& part, const std::optional<std::filesystem::path>& kept);

}  // namespace grader::judge

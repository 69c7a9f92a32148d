// STAFF ONLY. A run of a scene that was played elsewhere, beside the reference's own.
#pragma once

#include <string>
#include <vector>

#include "grader/suite/played.h"
#include "grader/suite/run_pictures.h"
#include "hair/scene/playback.h"

namespace grader {

struct Moment {
  double time = 0;                   // s
  hair::FrameMeasures ours, theirs;  // both by our forces
  double apart = 0;                  // m, the largest distance of a particle from the reference's
  double held_apart = 0;             // m, the same of those that are held
};

struct RunComparison {
  double size = 0;              // m: the diagonal of the box that holds the reference's run
  double kinetic = 0;           // J: its largest kinetic energy
  bool finite = true;           // all of their numbers
  std::vector<Moment> moments;  // that both have, until a number is not finite
  std::vector<Shot> shots;      // of the frames that were asked for, if they can be drawn
  hair::Camera camera;          // has all of the reference's run in its pictures
};

// Plays the scene with the reference. `pictures` are the frames of which there are to be shots. Throws
// std::logic_error if the reference itself breaks.
RunComparison compare_runs(const hair::Scene& scene, const std::vector<int>& pictures, const Played& theirs);

}  // namespace grader

// STAFF ONLY. Compares a worker's run of a scene with the reference's.
#pragma once

#include <string>
#include <vector>

#include "grader/judge/run/played.h"
#include "grader/judge/run/run_pictures.h"
#include "hair/scene/scene_run.h"

namespace grader::inline judge {

inline constexpr std::size_t kFilmShots = 12;

struct Moment {
  double time = 0;                   // s
  hair::FrameMeasures ours, theirs;  // both measured with our forces
  double apart = 0;                  // m, the largest distance between a point and the reference's
  double held_apart = 0;             // m, the same for held particles
  double dense_apart = 0;            // m, the same for points of dense hair
};

struct RunComparison {
  double size = 0;              // m: the diagonal of the bounding box of the reference's run
  double kinetic = 0;           // J: the largest kinetic energy in the reference's run
  bool finite = true;           // true if all of the worker's numbers are finite
  std::vector<Moment> moments;  // are in both runs, until a number is not finite
  std::vector<Shot>
      shots;  // frames that can be drawn: the requested ones, and the last one if others can't be
  // These three are empty if the runs look the same.
  std::string our_motion, their_motion;  // JSON of hair/view/motion.h: all frames that can be drawn
  std::vector<Shot> film;                // at most kFilmShots of these frames
  hair::Camera camera;                   // shows all of the reference's run
};

// Runs the scene with the reference. `pictures` are the frames for shots. Throws std::logic_error if the
// reference itself breaks.
RunComparison compare_runs(const hair::Scene& scene, const std::vector<int>& pictures, const Played& theirs);

}  // namespace grader::judge

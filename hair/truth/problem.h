// A problem of a study: one strand or one toy of a scene, for a short time, without what no method's error can be told
// apart from (obstacles, pictures, the other strands).
//
//   Scene ──▶ Problem ──▶ accurate motion          (accurate_motion.h)
//                    └──▶ a run with each method   (study_methods.h), for each of some step sizes
#pragma once

#include <optional>

#include "hair/scene/scene.h"

namespace hair {

// Real hair is stiff, and a strand that is long in the air feels every rounding: beyond this nothing is learned about
// a method.
inline constexpr double kLongestStudy = 0.2;  // s
inline constexpr int kMoments = 16;           // that runs are compared at, after the start
inline constexpr int kQuickSegments = 10;

struct ProblemSettings {
  int strand = 0;                       // counted from 0; of a scene without strands, the toy
  std::optional<double> duration = {};  // s; none: the scene's, but at most kLongestStudy
  std::optional<int> segments = {};     // the strand divided anew; none: as the scene has it
};

struct Problem {
  // One strand or one toy, without obstacles and look; its frames are the moments. Method and step are the run's: see
  // with_method.
  Scene scene;
  double duration = 0;  // s

  bool is_toy() const { return scene.hair.strands.empty(); }
};

// Throws BadInput for what the scene does not have, and for what can't be studied.
Problem make_problem(const Scene& scene, const ProblemSettings& settings);

// A strand as before in `segments` >= 1 equal segments: its mass for each metre, its length, rigidities, its root and the
// curve that it starts on are the same. Throws std::invalid_argument for a strand that rests curved: its curvature is
// known at the joints that it has.
StrandStart divide_anew(const StrandStart& start, int segments);

}  // namespace hair

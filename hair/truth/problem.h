// A problem of a study: one strand or one toy of a scene, for a short time. It leaves out everything that
// says nothing about a method's error (obstacles, pictures, the other strands).
//
//   Scene ──▶ Problem ──▶ accurate motion          (accurate_motion.h)
//                    └──▶ a run with each method   (study_methods.h), for each of several step sizes
#pragma once

#include <optional>

#include "hair/scene/scene.h"

namespace hair {

// Real hair is stiff, and rounding errors grow during a long motion: beyond this duration a study learns
// nothing about a method.
inline constexpr double kLongestStudy = 0.2;  // s
inline constexpr int kMoments = 16;           // at which runs are compared, after the start
inline constexpr int kQuickSegments = 10;

struct ProblemSettings {
  int strand = 0;                       // counted from 0; the index of a toy if there are no strands
  std::optional<double> duration = {};  // s; none: the scene's, but at most kLongestStudy
  std::optional<int> segments = {};     // divides the strand anew; none: the scene's segments
};

struct Problem {
  // One strand or one toy, without obstacles and look; its frames are the moments. Each run sets its own
  // method and step: with_method.
  Scene scene;
  double duration = 0;  // s

  bool is_toy() const { return scene.hair.strands.empty(); }
};

// Throws BadInput for a strand that the scene does not have, and for a problem that can't be studied.
Problem make_problem(const Scene& scene, const ProblemSettings& settings);

// The same strand in `segments` >= 1 equal segments: the mass per metre, the length, the rigidities, the root
// and the start curve stay the same. Throws std::invalid_argument for a strand that is curved at rest,
// because its curvature is known only at its original joints.
StrandStart divide_anew(const StrandStart& start, int segments);

}  // namespace hair

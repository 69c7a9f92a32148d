// A problem of a study: one strand or one toy of a scene, for a short time. Obstacles, pictures and other
// strands have nothing to do with a method's error and are left out.
//
//   Scene ──▶ Problem ──▶ accurate motion          (accurate_motion.h)
//                    └──▶ a run with each method   (study_methods.h), for each of several step sizes
#pragma once

#include <memory>
#include <optional>

#include "hair/scene/scene.h"
#include "hair/strand/body.h"

namespace hair {

// Real hair is stiff, and rounding errors grow during a long motion: beyond this duration a study learns
// nothing about a method.
inline constexpr double kLongestStudy = 0.2;  // s
inline constexpr int kMoments = 16;           // times after the start at which runs are compared
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

  bool is_toy() const { return !has_strands(scene); }

  // The strand, if its model divides it into elements. Null: one of masses and springs, or a toy.
  const ModelledStrand* modelled() const {
    return scene.hair.modelled.empty() ? nullptr : &scene.hair.modelled.front();
  }
};

// The body of a modelled strand, at the start.
std::unique_ptr<Body> modelled_body(const Problem& problem);

// Throws BadInput for a strand that the scene does not have, and for a problem that can't be studied. A
// modelled strand's method is one that moves its model.
Problem make_problem(const Scene& scene, const ProblemSettings& settings);

// The segments of a scene's strand, if it is a strand that can be divided anew. Nothing for a strand that is
// curved at rest, or without a strand.
std::optional<int> segments_to_divide(const Scene& scene, int strand);

// The same strand in `segments` >= 1 equal segments: the mass per metre, the length, the rigidities, the root
// and the start curve stay the same. Throws std::invalid_argument for a strand that is curved at rest,
// because its curvature is known only at its original joints.
StrandStart divide_anew(const StrandStart& start, int segments);

}  // namespace hair

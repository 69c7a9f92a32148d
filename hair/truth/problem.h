// A problem of a study: one strand or one toy of a scene, for a short time. Obstacles, pictures and other
// strands have nothing to do with a method's error and are left out.
//
//   Scene ──▶ Problem ──▶ accurate motion          (accurate_motion.h)
//                    └──▶ a run with each method   (study_methods.h), for each of several step sizes
#pragma once

#include <optional>
#include <string>

#include "hair/scene/scene.h"

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
};

// Throws BadInput for a strand that the scene does not have, and for a problem that can't be studied, such
// as a strand of another model than masses and springs.
Problem make_problem(const Scene& scene, const ProblemSettings& settings);

// The segments of a scene's strand, if it is a strand that can be divided anew. Nothing for a strand that is
// curved at rest, or without a strand.
std::optional<int> segments_to_divide(const Scene& scene, int strand);

// The same strand in `segments` >= 1 equal segments: the mass per metre, the length, the rigidities, the root
// and the start curve stay the same. Throws std::invalid_argument for a strand that is curved at rest,
// because its curvature is known only at its original joints.
StrandStart divide_anew(const StrandStart& start, int segments);

// A problem's content as a short text: two problems with the same text have the same motion.
// 16 hexadecimal digits, a digest of every number that the problem's motion depends on, bit by bit:
// particles, forces, roots, moments. It excludes the name, and the method, step and tolerance.
std::string content_of(const Problem& problem);

}  // namespace hair

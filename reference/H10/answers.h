// STAFF ONLY. Asks a student's functions of H10 through the pipe.
#pragma once

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "grader/judge/cases/trial.h"
#include "hair/strand_synthesis.h"
#include "reference/H10/calls.h"

namespace grader::h10 {

// Inputs of H10's hidden cases: triangles of roots, and guides with their points.

using Eigen::VectorXd;
using hair::GuideFrames, hair::Matrix3d, hair::RootFrame, hair::Vector3d;
using Corners = std::array<Vector3d, 3>;

// A guide that owns its points.
struct OwnGuide {
  RootFrame root;
  VectorXd points;

  hair::GuideHair view() const { return {root, {points.data(), points.size()}}; }
};

Vector3d some_direction(Random& random);
RootFrame some_root(Random& random);  // about 0.1 m from the origin
RootFrame moved_root(Random& random, const RootFrame& root,
                     double turn);  // a centimetre away, turned by about `turn`

// A triangle about a centimetre wide, 0.1 m from the origin. Its height on the longest edge is `height` of
// that edge.
Corners some_triangle(Random& random, double height);
double longest_edge(const Corners& corners);

// A guide of n points at distances of 1 to 9 mm, which turns by up to `turn` at each point.
OwnGuide some_guide(Random& random, int n, double turn);
OwnGuide straight_guide(Random& random, int n);  // along its root's axis

GuideFrames reference_frames(const VectorXd& guide);

using Weights = std::array<double, 3>;

inline constexpr auto ask_weights = answer_of<Calls, hair::root_weights>;

inline VectorXd ask_interpolated(Trial& trial, const std::array<OwnGuide, 3>& guides, const Weights& weights,
                                 const RootFrame& root) {
  const std::array<hair::GuideHair, 3> seen{guides[0].view(), guides[1].view(), guides[2].view()};
  return answer_of<Calls, hair::interpolate>(trial, seen, weights, root, unset(guides[0].points.size()));
}
inline GuideFrames ask_frames(Trial& trial, const VectorXd& guide) {
  const Matrix3d none = Matrix3d::Constant(kUnset);
  return answer_of<Calls, hair::carry_along>(
      trial, guide, GuideFrames{unset(guide.size() / 3), std::vector(guide.size() / 3, none)});
}
inline VectorXd ask_extrapolated(Trial& trial, const VectorXd& guide, const GuideFrames& frames,
                                 const Vector3d& root, double spread) {
  return answer_of<Calls, hair::extrapolate>(trial, guide, frames, root, spread, unset(guide.size()));
}

// The place of a blend's child: memory of its own, or one of the two strands that it is made of.
enum class Place { own, at_root, at_tip };

inline VectorXd ask_blended(Trial& trial, const VectorXd& arc, VectorXd at_root, VectorXd at_tip,
                            Place place) {
  VectorXd own = unset(at_root.size());
  VectorXd& child = place == Place::own ? own : place == Place::at_root ? at_root : at_tip;
  CaseAsker asker(trial);
  ask<Calls, hair::blend>(asker, arc, at_root, at_tip, child);
  return child;
}

// The part of the cases in other units that is about weights.
void weights_in_other_units(Trial& trial);

}  // namespace grader::h10

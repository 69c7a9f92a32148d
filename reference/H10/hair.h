// STAFF ONLY. Inputs of H10's hidden cases: triangles of roots, and guides with their points.
#pragma once

#include "grader/judge/cases/random.h"
#include "hair/strand_synthesis.h"

namespace grader::h10 {

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

}  // namespace grader::h10

// STAFF ONLY. Draws guides, roots and triangles for the cases of H10.
#include "reference/H10/answers.h"

#include <algorithm>

#include "grader/judge/cases/random.h"

namespace grader::h10 {
namespace {

OwnGuide along(Random& random, int n, double turn) {
  OwnGuide guide{some_root(random), VectorXd(3 * n)};
  Vector3d point = guide.root.position, direction = guide.root.axis;
  guide.points.head<3>() = point;
  for (int i = 1; i < n; ++i) {
    const double angle = random.uniform(0, turn);
    direction = Eigen::AngleAxisd(angle, direction.cross(some_direction(random)).normalized()) * direction;
    point += random.log_uniform(1e-3, 9e-3) * direction.normalized();
    guide.points.segment<3>(3 * i) = point;
  }
  return guide;
}

}  // namespace

Vector3d some_direction(Random& random) {
  return Vector3d(random_vector(random, 3)).normalized();
}

RootFrame some_root(Random& random) {
  RootFrame root{random_vector(random, 3, 0.1), some_direction(random), {}};
  root.side = root.axis.cross(some_direction(random)).normalized();
  return root;
}

RootFrame moved_root(Random& random, const RootFrame& root, double turn) {
  const double angle = random.uniform(0.5, 1) * turn;
  const Eigen::AngleAxisd by(angle, some_direction(random));
  RootFrame moved{root.position + random_vector(random, 3, 0.01), (by * root.axis).normalized(), {}};
  const Vector3d side = by * root.side;
  moved.side = (side - side.dot(moved.axis) * moved.axis).normalized();
  return moved;
}

Corners some_triangle(Random& random, double height) {
  const RootFrame at = some_root(random);
  const double edge = random.log_uniform(0.005, 0.02), foot = random.uniform(0.2, 0.8);
  const Vector3d across = at.axis.cross(at.side);
  Corners corners{at.position, at.position + edge * at.side,
                  at.position + edge * (foot * at.side + height * across)};
  std::rotate(corners.begin(), corners.begin() + random.integer(0, 2), corners.end());
  if (random.integer(0, 1) == 1) std::swap(corners[0], corners[1]);
  return corners;
}

double longest_edge(const Corners& corners) {
  return std::max(
      {(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(), (corners[0] - corners[2]).norm()});
}

OwnGuide some_guide(Random& random, int n, double turn) {
  return along(random, n, turn);
}

OwnGuide straight_guide(Random& random, int n) {
  return along(random, n, 0);
}

GuideFrames reference_frames(const VectorXd& guide) {
  const auto n = static_cast<std::size_t>(guide.size() / 3);
  GuideFrames frames{VectorXd(guide.size() / 3), std::vector<Matrix3d>(n)};
  hair::carry_along(guide, frames);
  return frames;
}

}  // namespace grader::h10

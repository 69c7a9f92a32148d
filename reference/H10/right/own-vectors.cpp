// STAFF ONLY. H10 with vectors and quaternions of its own, weights by a search over the triangle's features, and strands from
// their tips to their roots.
#include "hair/strand_synthesis.h"

#include <cmath>

namespace {

struct Vec {
  double x = 0, y = 0, z = 0;
};
Vec operator+(Vec a, Vec b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec operator*(double s, Vec a) {
  return {s * a.x, s * a.y, s * a.z};
}
double dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(Vec a) {
  return std::hypot(a.x, a.y, a.z);
}

Vec vec(const hair::Vector3d& a) {
  return {a[0], a[1], a[2]};
}
template <typename Points>
Vec point(const Points& points, Eigen::Index i) {
  return {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
}
void set(hair::Output points, Eigen::Index i, Vec a) {
  points[3 * i] = a.x;
  points[3 * i + 1] = a.y;
  points[3 * i + 2] = a.z;
}

struct Quaternion {
  double w = 1;
  Vec v;
};
Quaternion operator*(Quaternion a, Quaternion b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
Quaternion scaled_to_1(Quaternion q) {
  const double size = std::sqrt(q.w * q.w + dot(q.v, q.v));
  return {q.w / size, 1 / size * q.v};
}
Vec turned(Quaternion q, Vec a) {
  const Vec t = 2.0 * cross(q.v, a);
  return a + q.w * t + cross(q.v, t);
}

// Half of the way from a to b: |a + b| is twice the cosine of half of the angle.
Quaternion between(Vec a, Vec b) {
  const Vec sum = a + b;
  const double size = length(sum);
  if (size < 1e-7) {
    const Vec other = std::abs(a.x) < 0.6 ? Vec{1, 0, 0} : Vec{0, 1, 0};
    return scaled_to_1({0, cross(a, other)});
  }
  const Vec half = 1 / size * sum;
  return scaled_to_1({dot(a, half), cross(a, half)});
}

// A vector in the frame's axes, and back.
Vec seen_by(const hair::RootFrame& frame, Vec a) {
  const Vec axis = vec(frame.axis), side = vec(frame.side);
  return {dot(axis, a), dot(side, a), dot(cross(axis, side), a)};
}
Vec in_space(const hair::RootFrame& frame, Vec a) {
  const Vec axis = vec(frame.axis), side = vec(frame.side);
  return a.x * axis + a.y * side + a.z * cross(axis, side);
}

struct Nearest {
  std::array<double, 3> weights;
  double distance;
};

}  // namespace

namespace hair {

std::array<double, 3> root_weights(const std::array<Vector3d, 3>& corners, const Vector3d& root) {
  const Vec p = vec(root);
  Nearest best{{1, 0, 0}, length(p - vec(corners[0]))};
  const auto offer = [&](std::array<double, 3> weights) {
    Vec at;
    for (int k = 0; k < 3; ++k) at = at + weights[k] * vec(corners[k]);
    const double distance = length(p - at);
    if (distance < best.distance) best = {weights, distance};
  };
  offer({0, 1, 0});
  offer({0, 0, 1});
  double longest = 0;
  for (int k = 2; k >= 0; --k) {
    const int next = (k + 1) % 3;
    const Vec edge = vec(corners[next]) - vec(corners[k]);
    longest = std::max(longest, dot(edge, edge));
    const double t = dot(p - vec(corners[k]), edge) / dot(edge, edge);
    if (!(t > 0 && t < 1)) continue;
    std::array<double, 3> weights{};
    weights[k] = 1 - t;
    weights[next] = t;
    offer(weights);
  }
  const Vec a = vec(corners[0]), b = vec(corners[1]), c = vec(corners[2]);
  const Vec area = cross(b - a, c - a);
  const double size = length(area);
  if (!(size > 1e-7 * longest)) return best.weights;
  const Vec up = 1 / size * area;
  const double first = dot(up, cross(b - p, c - p)), second = dot(up, cross(c - p, a - p)),
               third = dot(up, cross(a - p, b - p)), sum = first + second + third;
  if (first > 0 && second > 0 && third > 0) return {first / sum, second / sum, third / sum};
  return best.weights;
}

void interpolate(const std::array<GuideHair, 3>& guides, const std::array<double, 3>& weights,
                 const RootFrame& root, Output child) {
  for (Eigen::Index i = child.size() / 3 - 1; i >= 0; --i) {
    Vec seen;
    for (int k = 2; k >= 0; --k)
      seen = seen +
             weights[k] * seen_by(guides[k].root, point(guides[k].points, i) - vec(guides[k].root.position));
    set(child, i, vec(root.position) + in_space(root, seen));
  }
}

void carry_along(Input guide, GuideFrames& frames) {
  const auto n = static_cast<Eigen::Index>(frames.turns.size());
  double gone = 0;
  for (Eigen::Index i = 1; i < n; ++i) gone += length(point(guide, i) - point(guide, i - 1));
  const double whole = gone;
  Quaternion turn;
  Vec direction;
  gone = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vec segment = i == 0 ? Vec{} : point(guide, i) - point(guide, i - 1);
    const double size = length(segment);
    if (size > 0) {
      if (gone > 0) turn = scaled_to_1(between(direction, 1 / size * segment) * turn);
      gone += size;
      direction = 1 / size * segment;
    }
    frames.arc[i] = gone > 0 ? gone / whole : 0;
    for (int k = 0; k < 3; ++k) {
      const Vec column = turned(turn, {k == 0 ? 1.0 : 0, k == 1 ? 1.0 : 0, k == 2 ? 1.0 : 0});
      frames.turns[i](0, k) = column.x;
      frames.turns[i](1, k) = column.y;
      frames.turns[i](2, k) = column.z;
    }
  }
}

void extrapolate(Input guide, const GuideFrames& frames, const Vector3d& root, double spread, Output child) {
  for (Eigen::Index i = frames.arc.size() - 1; i >= 0; --i) {
    const double arc = frames.arc[i];
    const Vec offset = (1 - arc + spread * arc) * (vec(root) - point(guide, 0));
    const Matrix3d& turn = frames.turns[i];
    const Vec rotated{turn(0, 0) * offset.x + turn(0, 1) * offset.y + turn(0, 2) * offset.z,
                      turn(1, 0) * offset.x + turn(1, 1) * offset.y + turn(1, 2) * offset.z,
                      turn(2, 0) * offset.x + turn(2, 1) * offset.y + turn(2, 2) * offset.z};
    set(child, i, point(guide, i) + rotated);
  }
}

void blend(Input arc, Input at_root, Input at_tip, Output child) {
  for (Eigen::Index i = arc.size() - 1; i >= 0; --i) {
    const double s = arc[i], w = s * s * (1 + 2 * (1 - s));
    for (Eigen::Index k = 3 * i; k < 3 * i + 3; ++k) child[k] = at_root[k] + w * (at_tip[k] - at_root[k]);
  }
}

}  // namespace hair

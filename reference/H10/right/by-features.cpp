// STAFF ONLY. H10 by features: the triangle, its edges and its corners each have a nearest point, and the
// nearest of these counts. Frames go by their components, and a turn takes a basis to a basis.
#include "hair/strand_synthesis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hair {
namespace {

using Weights = std::array<double, 3>;

struct Nearest {
  const std::array<Vector3d, 3>& corners;
  const Vector3d& root;
  Weights weights{1, 0, 0};
  double squared = std::numeric_limits<double>::infinity();

  void offer(const Weights& one) {
    if (!(std::min({one[0], one[1], one[2]}) >= 0)) return;
    const Vector3d way =
        one[0] * (corners[0] - root) + one[1] * (corners[1] - root) + one[2] * (corners[2] - root);
    if (way.squaredNorm() >= squared) return;
    squared = way.squaredNorm();
    weights = one;
  }
};

// A unit vector across `along`, of length 1: as near to `wanted` as possible, or any.
Vector3d across(const Vector3d& along, const Vector3d& wanted) {
  Vector3d one = wanted - along * along.dot(wanted);
  if (one.squaredNorm() == 0) {
    int least = 0;
    along.cwiseAbs().minCoeff(&least);
    one = along.cross(Vector3d::Unit(least));
  }
  one.normalize();
  // The projection is made twice, since a short remainder has large rounding errors.
  return (one - along * along.dot(one)).normalized();
}

}  // namespace

std::array<double, 3> root_weights(const std::array<Vector3d, 3>& corners, const Vector3d& root) {
  Nearest nearest{corners, root};
  double longest = 0;
  for (int a = 0; a < 3; ++a) {
    Weights corner{};
    corner[a] = 1;
    nearest.offer(corner);
    longest = std::max(longest, (corners[(a + 1) % 3] - corners[a]).norm());
  }
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const Vector3d edge = corners[b] - corners[a];
    const double size = edge.norm();
    if (size == 0) continue;
    const Vector3d x = edge / size;
    Weights on_edge{};
    on_edge[b] = x.dot(root - corners[a]) / size;
    on_edge[a] = 1 - on_edge[b];
    nearest.offer(on_edge);
    if (size < longest) continue;
    // The longest edge and the height on it are a frame of the plane.
    const Vector3d third = corners[c] - corners[a], up = third - x * x.dot(third);
    const double height = up.norm();
    if (height < 1e-9 * size) continue;
    Weights inside;
    inside[c] = up.dot(root - corners[a]) / (height * height);
    inside[b] = x.dot(root - corners[a] - inside[c] * third) / size;
    inside[a] = 1 - inside[b] - inside[c];
    nearest.offer(inside);
  }
  return nearest.weights;
}

void interpolate(const std::array<GuideHair, 3>& guides, const std::array<double, 3>& weights,
                 const RootFrame& root, Output child) {
  for (Eigen::Index i = child.size() / 3; i-- > 0;) {
    double out = 0, aside = 0, third = 0;
    for (int k = 0; k < 3; ++k) {
      const RootFrame& frame = guides[k].root;
      const Vector3d seen = guides[k].points.segment<3>(3 * i) - frame.position;
      out += weights[k] * frame.axis.dot(seen);
      aside += weights[k] * frame.side.dot(seen);
      third += weights[k] * frame.axis.cross(frame.side).dot(seen);
    }
    child.segment<3>(3 * i) =
        root.position + out * root.axis + aside * root.side + third * root.axis.cross(root.side);
  }
}

void carry_along(Input guide, GuideFrames& frames) {
  const Eigen::Index n = frames.arc.size();
  double whole = 0;
  for (Eigen::Index i = 1; i < n; ++i)
    whole += (guide.segment<3>(3 * i) - guide.segment<3>(3 * (i - 1))).norm();
  double so_far = 0;
  bool begun = false;
  Vector3d u, v;
  Matrix3d turn = Matrix3d::Identity();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector3d step =
        i == 0 ? Vector3d(0, 0, 0) : Vector3d(guide.segment<3>(3 * i) - guide.segment<3>(3 * (i - 1)));
    const double size = step.norm();
    so_far += size;
    frames.arc[i] = whole > 0 ? so_far / whole : 0;
    if (size > 0) {
      v = step / size;
      if (begun) {
        // (u, a, u x a) becomes (v, a, v x a).
        const Vector3d a = across(u, u.cross(v));
        turn = (v * u.transpose() + a * a.transpose() + v.cross(a) * u.cross(a).transpose()) * turn;
      }
      u = v;
      begun = true;
    }
    frames.turns[static_cast<std::size_t>(i)] = turn;
  }
}

void extrapolate(Input guide, const GuideFrames& frames, const Vector3d& root, double spread, Output child) {
  for (Eigen::Index i = frames.arc.size(); i-- > 0;) {
    const Matrix3d& turn = frames.turns[static_cast<std::size_t>(i)];
    const Vector3d stick = turn * root - turn * guide.head<3>();
    child.segment<3>(3 * i) =
        guide.segment<3>(3 * i) + (1 - frames.arc[i]) * stick + frames.arc[i] * spread * stick;
  }
}

void blend(Input arc, Input at_root, Input at_tip, Output child) {
  for (Eigen::Index at = 0; at < child.size(); ++at) {
    const double s = arc[at / 3], w = 1 - (1 - s) * (1 - s) * (1 + 2 * s);
    child[at] = at_root[at] + w * (at_tip[at] - at_root[at]);
  }
}

}  // namespace hair

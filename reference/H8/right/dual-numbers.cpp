// STAFF ONLY. A right solution of H8 in long double: Jacobians by dual numbers, with three derivatives each; the mass matrix
// from what hangs on each element, as one body; and elimination for the step.

#include "hair/super_helix.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

using Real = long double;
using Long3 = Eigen::Matrix<Real, 3, 1>;
using Long33 = Eigen::Matrix<Real, 3, 3>;
using Six3 = Eigen::Matrix<Real, 6, 3>;
using Six6 = Eigen::Matrix<Real, 6, 6>;

// A number and its derivatives by kappa1, kappa2 and tau.
struct Dual {
  Real value = 0;
  Long3 slopes = Long3::Zero();
};
Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.slopes + b.slopes};
}
Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.slopes - b.slopes};
}
Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.slopes * b.value + b.slopes * a.value};
}

using Vec = std::array<Dual, 3>;
Vec operator+(const Vec& a, const Vec& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec operator*(const Dual& s, const Vec& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Long3 values(const Vec& a) {
  return {a[0].value, a[1].value, a[2].value};
}
Long3 slopes(const Vec& a, int k) {
  return {a[0].slopes[k], a[1].slopes[k], a[2].slopes[k]};
}

using Stumpff = std::array<Real, 10>;

// The two highest by their series, the others from them; where x is large the two lowest, and the others from them.
Stumpff stumpff_of(Real x) {
  Stumpff c, inverse;  // inverse[k]: 1/k!
  inverse[0] = 1;
  for (int k = 1; k < 10; ++k) inverse[k] = inverse[k - 1] / k;
  if (x < 4) {
    for (int k = 8; k < 10; ++k) {
      Real term = inverse[k];
      c[k] = 0;
      for (int m = 1; m < 20; ++m) {
        c[k] += term;
        term *= -x / ((k + 2 * m - 1) * (k + 2 * m));
      }
    }
    for (int k = 7; k >= 0; --k) c[k] = inverse[k] - x * c[k + 2];
  } else {
    const Real a = std::sqrt(x);
    c[0] = std::cos(a);
    c[1] = std::sin(a) / a;
    for (int k = 2; k < 10; ++k) c[k] = (inverse[k - 2] - c[k - 2]) / x;
  }
  return c;
}

// Along the axes of the start.
struct Helix {
  Vec position;
  std::array<Vec, 3> axes;
};

Helix helix(const Vector3d& curvature, Real s) {
  Vec p;
  Dual x;
  for (int k = 0; k < 3; ++k) {
    p[k] = {s * curvature[k], s * Long3::Unit(k)};
    x = x + p[k] * p[k];
  }
  const Stumpff c = stumpff_of(x.value);
  const auto dual = [&](int k) -> Dual { return {c[k], (k * c[k + 2] - c[k + 1]) / 2 * x.slopes}; };
  const Dual c1 = dual(1), c2 = dual(2), c3 = dual(3), one{1}, length{s};
  Helix at;
  for (int k = 0; k < 3; ++k) {
    Vec unit;
    unit[k] = one;
    const Vec first = cross(p, unit), second = cross(p, first);
    at.axes[k] = unit + c1 * first + c2 * second;
    if (k == 2) at.position = length * (unit + c2 * first + c3 * second);
  }
  return at;
}

struct Frame {
  Long3 position;
  Long33 axes;
};
Frame wide(const MaterialFrame& frame) {
  return {frame.position.cast<Real>(), frame.axes.cast<Real>()};
}
MaterialFrame narrow(const Frame& frame) {
  return {frame.position.cast<double>(), frame.axes.cast<double>()};
}
Frame along(const Frame& start, const Helix& at) {
  Frame frame{start.position + start.axes * values(at.position), {}};
  for (int k = 0; k < 3; ++k) frame.axes.col(k) = start.axes * values(at.axes[k]);
  return frame;
}

Long33 cross_matrix(const Long3& r) {
  Long33 m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

// [velocity; spin] at a point of a body, of those at another one that is r behind; its transpose carries forces back.
Six6 carried(const Long3& r) {
  Six6 X = Six6::Identity();
  X.topRightCorner<3, 3>() = -cross_matrix(r);
  return X;
}

Six3 motions(const HelixElement& element) {
  Six3 S;
  S << element.at_end.moves.cast<Real>(), element.at_end.turns.cast<Real>();
  return S;
}

Long3 arm(const Vector3d& from, const Vector3d& to) {
  return to.cast<Real>() - from.cast<Real>();
}

}  // namespace

std::array<double, 8> stumpff(double x) {
  const Stumpff c = stumpff_of(x);
  std::array<double, 8> result;
  for (int k = 0; k < 8; ++k) result[k] = static_cast<double>(c[k]);
  return result;
}

MaterialFrame frame_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  return narrow(along(wide(start), helix(curvature, s)));
}

void carry_frames(const MaterialFrame& root, std::vector<HelixElement>& elements) {
  Frame frame = wide(root);
  for (HelixElement& element : elements) {
    element.start = narrow(frame);
    frame = along(frame, helix(element.curvature, element.length));
    element.end = narrow(frame);
  }
}

void helix_stiffness(const HelixStrand& strand, Output K) {
  for (Eigen::Index k = 0; k < K.size(); ++k)
    K[k] = strand.lengths[k / 3] * (k % 3 < 2 ? strand.bend_rigidity : strand.twist_rigidity);
}

void elastic_force(const HelixStrand& strand, Input q, Output force) {
  helix_stiffness(strand, force);
  force.array() *= strand.natural.array() - q.array();
}

// A frame's turn is half the sum of its axes times their changes.
HelixJacobian jacobian_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const Helix at = helix(curvature, s);
  const Long33 axes = start.axes.cast<Real>();
  HelixJacobian J;
  for (int k = 0; k < 3; ++k) {
    Long3 turn = Long3::Zero();
    for (const Vec& axis : at.axes) turn += values(axis).cross(slopes(axis, k)) / 2;
    J.turns.col(k) = (axes * turn).cast<double>();
    J.moves.col(k) = (axes * slopes(at.position, k)).cast<double>();
  }
  return J;
}

void generalised_force(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                       Output Q) {
  Eigen::Matrix<Real, 6, 1> beyond = Eigen::Matrix<Real, 6, 1>::Zero();  // about the element's end
  auto point = points.rbegin();
  for (int i = static_cast<int>(elements.size()) - 1; i >= 0; --i) {
    Long3 sum = motions(elements[i]).transpose() * beyond;
    if (i > 0)
      beyond = carried(arm(elements[i - 1].end.position, elements[i].end.position)).transpose() * beyond;
    for (; point != points.rend() && point->element == i; ++point) {
      const Long3 force = point->force.cast<Real>();
      sum += point->moves.cast<Real>().transpose() * force;
      if (i == 0) continue;
      beyond.head<3>() += force;
      beyond.tail<3>() += arm(elements[i - 1].end.position, point->position).cross(force);
    }
    Q.segment<3>(3 * i) = sum.cast<double>();
  }
}

// What lies beyond an element's end is one body there; forces that move an element are carried towards the root, and meet the
// motions of the others.
void mass_matrix(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                 Eigen::Ref<Eigen::MatrixXd> M) {
  Six6 body = Six6::Zero();
  auto point = points.rbegin();
  for (int i = static_cast<int>(elements.size()) - 1; i >= 0; --i) {
    const Six3 own = motions(elements[i]);
    Six3 force = body * own;
    Long33 diagonal = own.transpose() * force;
    Six6 X = Six6::Identity();
    if (i > 0) X = carried(arm(elements[i - 1].end.position, elements[i].end.position));
    body = X.transpose() * body * X;
    force = X.transpose() * force;
    for (; point != points.rend() && point->element == i; ++point) {
      const Long33 moves = point->moves.cast<Real>(), inertia = point->inertia.cast<Real>();
      diagonal += moves.transpose() * inertia * moves;
      if (i == 0) continue;
      const Eigen::Matrix<Real, 3, 6> here =
          carried(arm(elements[i - 1].end.position, point->position)).topRows<3>();
      force += here.transpose() * inertia * moves;
      body += here.transpose() * inertia * here;
    }
    M.block<3, 3>(3 * i, 3 * i) = diagonal.cast<double>();
    for (int j = i - 1; j >= 0; --j) {
      const Long33 block = motions(elements[j]).transpose() * force;
      M.block<3, 3>(3 * j, 3 * i) = block.cast<double>();
      M.block<3, 3>(3 * i, 3 * j) = block.transpose().cast<double>();
      if (j > 0)
        force = carried(arm(elements[j - 1].end.position, elements[j].end.position)).transpose() * force;
    }
  }
}

void helix_step(const HelixStrand& strand, const std::vector<HelixElement>& elements,
                const std::vector<HelixPoint>& points, Input q, Input rates, double h, Scratch scratch,
                Output change) {
  const Eigen::Index size = q.size();
  auto M = scratch.leftCols(size);
  auto K = scratch.col(size), Q = scratch.col(size + 1);
  mass_matrix(elements, points, M);
  helix_stiffness(strand, K);
  generalised_force(elements, points, Q);
  std::vector<Real> A(static_cast<std::size_t>(size * size)), b(static_cast<std::size_t>(size));
  const auto row = [&](Eigen::Index i) { return A.begin() + i * size; };
  const Real step = h;
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) row(i)[j] = M(i, j);
    row(i)[i] += step * step * K[i];
    b[i] = step * (Q[i] - K[i] * (q[i] + step * rates[i] - strand.natural[i]));
  }
  for (Eigen::Index k = 0; k < size; ++k)
    for (Eigen::Index i = k + 1; i < size; ++i) {
      const Real factor = row(i)[k] / row(k)[k];
      for (Eigen::Index j = k; j < size; ++j) row(i)[j] -= factor * row(k)[j];
      b[i] -= factor * b[k];
    }
  for (Eigen::Index i = size - 1; i >= 0; --i) {
    for (Eigen::Index j = i + 1; j < size; ++j) b[i] -= row(i)[j] * b[j];
    b[i] /= row(i)[i];
    change[i] = static_cast<double>(b[i]);
  }
}

}  // namespace hair

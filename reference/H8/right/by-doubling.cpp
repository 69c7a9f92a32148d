// STAFF ONLY. A right solution of H8 that makes an element of two halves, again and again, from a piece so
// short that five nodes of Gauss integrate it. Stumpff's functions use the same idea. It uses long double,
// and a Cholesky factorisation of its own.

#include "hair/super_helix.h"

#include <cmath>
#include <vector>

namespace hair {
namespace {

using Real = long double;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

Matrix3 crossing(const Vector3& p) {
  Matrix3 X;
  X << 0, -p[2], p[1], p[2], 0, -p[0], -p[1], p[0], 0;
  return X;
}

// The sum of X^n / (n + more)! for a small X.
Matrix3 exponential(const Matrix3& X, int more) {
  Matrix3 sum = Matrix3::Zero(), power = Matrix3::Identity();
  Real factorial = 1;
  for (int n = 0; n < 16; ++n) {
    if (n + more > 0) factorial *= n + more;
    sum += power / factorial;
    power = power * X;
  }
  return sum;
}

// A piece of an element, in the axes of its start.
struct Piece {
  Matrix3 axes, turns, moves;
  Vector3 end;
};

Piece short_piece(const Vector3& curvature, Real s) {
  const Matrix3 X = crossing(curvature);
  const auto axes_at = [&](Real at) { return exponential(at * X, 0); };
  const auto point_at = [&](Real at) { return Vector3(at * exponential(at * X, 1).col(2)); };
  Piece piece{axes_at(s), Matrix3::Zero(), Matrix3::Zero(), point_at(s)};
  const Real far = std::sqrt(5 + 2 * std::sqrt(10.0L / 7)) / 3,
             near = std::sqrt(5 - 2 * std::sqrt(10.0L / 7)) / 3;
  const Real light = (322 - 13 * std::sqrt(70.0L)) / 900, heavy = (322 + 13 * std::sqrt(70.0L)) / 900;
  const Real node[] = {-far, -near, 0, near, far}, weight[] = {light, heavy, 128.0L / 225, heavy, light};
  for (int j = 0; j < 5; ++j) {
    const Real at = (1 + node[j]) / 2 * s;
    const Matrix3 axes = axes_at(at);
    const Vector3 arm = piece.end - point_at(at);
    piece.turns += weight[j] * s / 2 * axes;
    piece.moves -= weight[j] * s / 2 * crossing(arm) * axes;
  }
  return piece;
}

Piece twice(const Piece& half) {
  Piece piece;
  const Vector3 second = half.axes * half.end;
  piece.axes = half.axes * half.axes;
  piece.end = half.end + second;
  piece.turns = half.turns + half.axes * half.turns;
  piece.moves = half.moves - crossing(second) * half.turns + half.axes * half.moves;
  return piece;
}

Piece piece_of(const Vector3d& curvature, double s) {
  Real length = s;
  int doublings = 0;
  for (; length * static_cast<Real>(curvature.norm()) > 0.01L; ++doublings) length /= 2;
  Piece piece = short_piece(curvature.cast<Real>(), length);
  for (; doublings > 0; --doublings) piece = twice(piece);
  return piece;
}

Matrix3d columns(const std::vector<HelixElement>& elements, int number, const HelixPoint& point) {
  if (number == point.element) return point.moves;
  Matrix3d moved;
  for (int k = 0; k < 3; ++k)
    moved.col(k) = Vector3d(elements[number].at_end.turns.col(k))
                       .cross(Vector3d(point.position - elements[number].end.position)) +
                   elements[number].at_end.moves.col(k);
  return moved;
}

}  // namespace

// Begins at x / 4^m, where the series has few terms, and doubles the angle of cos, sin and the two functions
// after them.
std::array<double, 8> stumpff(double x) {
  Real small = x;
  int doublings = 0;
  for (; small > 1; ++doublings) small /= 4;
  std::array<Real, 8> c;
  Real factorial = 1;
  for (int k = 0; k < 8; ++k) {
    if (k > 0) factorial *= k;
    Real term = 1 / factorial;
    c[k] = 0;
    for (int m = 0; m < 14; ++m) {
      c[k] += term;
      term *= -small / ((k + 2 * m + 1) * (k + 2 * m + 2));
    }
  }
  for (int m = 0; m < doublings; ++m) {
    c[3] = (c[2] + c[0] * c[3]) / 4;
    c[2] = c[1] * c[1] / 2;
    c[1] = c[0] * c[1];
    c[0] = 2 * c[0] * c[0] - 1;
  }
  if (doublings > 0) {
    const Real X = x;
    c[2] = (1 - c[0]) / X;
    c[3] = (1 - c[1]) / X;
    c[4] = (0.5L - c[2]) / X;
    c[5] = (1.0L / 6 - c[3]) / X;
    c[6] = (1.0L / 24 - c[4]) / X;
    c[7] = (1.0L / 120 - c[5]) / X;
  }
  std::array<double, 8> rounded;
  for (int k = 0; k < 8; ++k) rounded[k] = static_cast<double>(c[k]);
  return rounded;
}

MaterialFrame frame_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const Piece piece = piece_of(curvature, s);
  return {start.position + start.axes * piece.end.cast<double>(), start.axes * piece.axes.cast<double>()};
}

void carry_frames(const MaterialFrame& root, std::vector<HelixElement>& elements) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    elements[i].start = i == 0 ? root : elements[i - 1].end;
    elements[i].end = frame_at(elements[i].start, elements[i].curvature, elements[i].length);
  }
}

void helix_stiffness(const HelixStrand& strand, Output K) {
  for (Eigen::Index k = 0; k < K.size(); ++k)
    K[k] = (k % 3 == 2 ? strand.twist_rigidity : strand.bend_rigidity) * strand.lengths[k / 3];
}

void elastic_force(const HelixStrand& strand, Input q, Output force) {
  for (Eigen::Index k = 0; k < q.size(); ++k)
    force[k] = (k % 3 == 2 ? strand.twist_rigidity : strand.bend_rigidity) * strand.lengths[k / 3] *
               (strand.natural[k] - q[k]);
}

HelixJacobian jacobian_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const Piece piece = piece_of(curvature, s);
  return {start.axes * piece.turns.cast<double>(), start.axes * piece.moves.cast<double>()};
}

void generalised_force(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                       Output Q) {
  for (int i = 0; i < static_cast<int>(elements.size()); ++i) {
    Vector3 sum = Vector3::Zero();
    for (const HelixPoint& point : points)
      if (point.element >= i)
        sum += columns(elements, i, point).transpose().cast<Real>() * point.force.cast<Real>();
    Q.segment<3>(3 * i) = sum.cast<double>();
  }
}

void mass_matrix(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                 Eigen::Ref<Eigen::MatrixXd> M) {
  M.setZero();
  for (const HelixPoint& point : points)
    for (int i = 0; i <= point.element; ++i) {
      const Matrix3d carried = columns(elements, i, point).transpose() * point.inertia;
      for (int k = 0; k <= i; ++k) M.block<3, 3>(3 * i, 3 * k) += carried * columns(elements, k, point);
    }
  for (Eigen::Index k = 0; k < M.rows(); ++k)
    for (Eigen::Index m = 0; m < k; ++m) M(m, k) = M(k, m);
}

void helix_step(const HelixStrand& strand, const std::vector<HelixElement>& elements,
                const std::vector<HelixPoint>& points, Input q, Input rates, double h, Scratch scratch,
                Output change) {
  const Eigen::Index size = q.size();
  auto A = scratch.leftCols(size);
  auto K = scratch.col(size), Q = scratch.col(size + 1), elastic = scratch.col(size + 2);
  auto ahead = scratch.col(size + 3);
  mass_matrix(elements, points, A);
  helix_stiffness(strand, K);
  generalised_force(elements, points, Q);
  ahead = q + h * rates;
  elastic_force(strand, ahead, elastic);
  std::vector<Real> L(static_cast<std::size_t>(size * size)), y(static_cast<std::size_t>(size));
  const auto at = [&](Eigen::Index i, Eigen::Index j) -> Real& { return L[i * size + j]; };
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) {
      Real sum = A(i, j);
      if (i == j) sum += static_cast<Real>(h) * h * K[i];
      for (Eigen::Index k = 0; k < j; ++k) sum -= at(i, k) * at(j, k);
      at(i, j) = i == j ? std::sqrt(sum) : sum / at(j, j);
    }
  for (Eigen::Index i = 0; i < size; ++i) {
    y[i] = static_cast<Real>(h) * (static_cast<Real>(Q[i]) + elastic[i]);
    for (Eigen::Index k = 0; k < i; ++k) y[i] -= at(i, k) * y[k];
    y[i] /= at(i, i);
  }
  for (Eigen::Index i = size; i-- > 0;) {
    for (Eigen::Index k = i + 1; k < size; ++k) y[i] -= at(k, i) * y[k];
    y[i] /= at(i, i);
    change[i] = static_cast<double>(y[i]);
  }
}

}  // namespace hair

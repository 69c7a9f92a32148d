// STAFF ONLY. A right solution of H8 as the lecture has it: a Jacobian for each point, full matrices, and
// Eigen's LDLT.

#include "hair/super_helix.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace hair {
namespace {

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// The columns of J that belong to one element.
Matrix3d columns(const HelixElement& element, int number, const HelixPoint& point) {
  if (number == point.element) return point.moves;
  const Vector3d arm = point.position - element.end.position;
  return element.at_end.moves - cross_matrix(arm) * element.at_end.turns;
}

}  // namespace

std::array<double, 8> stumpff(double x) {
  std::array<double, 8> c;
  double factorial = 1;  // k!
  if (x < 1) {
    for (int k = 0; k < 8; ++k) {
      if (k > 0) factorial *= k;
      double sum = 0;
      for (int m = 10; m >= 0; --m) sum = 1 - x / ((k + 2 * m + 1) * (k + 2 * m + 2)) * sum;
      c[k] = sum / factorial;
    }
  } else {
    const double a = std::sqrt(x);
    c[0] = std::cos(a);
    c[1] = std::sin(a) / a;
    for (int k = 0; k < 6; ++k) {
      if (k > 0) factorial *= k;
      c[k + 2] = (1 / factorial - c[k]) / x;
    }
  }
  return c;
}

MaterialFrame frame_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const Vector3d p = s * curvature;
  const std::array<double, 8> c = stumpff(p.dot(p));
  const Matrix3d px = cross_matrix(p), one = Matrix3d::Identity();
  MaterialFrame frame;
  frame.axes = start.axes * (one + c[1] * px + c[2] * px * px);
  frame.position = start.position + s * start.axes * (one + c[2] * px + c[3] * px * px).col(2);
  return frame;
}

void carry_frames(const MaterialFrame& root, std::vector<HelixElement>& elements) {
  MaterialFrame frame = root;
  for (HelixElement& element : elements) {
    element.start = frame;
    frame = frame_at(element.start, element.curvature, element.length);
    element.end = frame;
  }
}

void helix_stiffness(const HelixStrand& strand, Output K) {
  for (int i = 0; i < strand.elements(); ++i) {
    K[3 * i] = strand.bend_rigidity * strand.lengths[i];
    K[3 * i + 1] = strand.bend_rigidity * strand.lengths[i];
    K[3 * i + 2] = strand.twist_rigidity * strand.lengths[i];
  }
}

void elastic_force(const HelixStrand& strand, Input q, Output force) {
  Eigen::VectorXd K(q.size());
  helix_stiffness(strand, K);
  force = -K.cwiseProduct(q - strand.natural);
}

HelixJacobian jacobian_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const Vector3d p = s * curvature, e(0, 0, 1);
  const std::array<double, 8> c = stumpff(p.dot(p));
  const double slope_2 = (2 * c[4] - c[3]) / 2, slope_3 = (3 * c[5] - c[4]) / 2;
  const Matrix3d px = cross_matrix(p);
  HelixJacobian J;
  J.turns = s * start.axes * (Matrix3d::Identity() + c[2] * px + c[3] * px * px);
  for (int k = 0; k < 3; ++k) {
    const Vector3d u = Vector3d::Unit(k), pe = p.cross(e), ue = u.cross(e);
    const double dx = 2 * p[k];
    const Vector3d moved =
        slope_2 * dx * pe + c[2] * ue + slope_3 * dx * p.cross(pe) + c[3] * (u.cross(pe) + p.cross(ue));
    J.moves.col(k) = s * s * start.axes * moved;
  }
  return J;
}

void generalised_force(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                       Output Q) {
  Q.setZero();
  for (const HelixPoint& point : points)
    for (int i = 0; i <= point.element; ++i)
      Q.segment<3>(3 * i) += columns(elements[i], i, point).transpose() * point.force;
}

void mass_matrix(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                 Eigen::Ref<Eigen::MatrixXd> M) {
  M.setZero();
  Eigen::Matrix3Xd J(3, M.cols());
  for (const HelixPoint& point : points) {
    const int known = 3 * (point.element + 1);
    for (int i = 0; i <= point.element; ++i) J.middleCols<3>(3 * i) = columns(elements[i], i, point);
    M.topLeftCorner(known, known) += J.leftCols(known).transpose() * point.inertia * J.leftCols(known);
  }
}

void helix_step(const HelixStrand& strand, const std::vector<HelixElement>& elements,
                const std::vector<HelixPoint>& points, Input q, Input rates, double h, Scratch scratch,
                Output change) {
  const Eigen::Index size = q.size();
  auto matrix = scratch.leftCols(size);
  Eigen::VectorXd K(size), Q(size), elastic(size);
  mass_matrix(elements, points, matrix);
  helix_stiffness(strand, K);
  generalised_force(elements, points, Q);
  elastic_force(strand, q + h * rates, elastic);
  matrix.diagonal() += h * h * K;
  change = matrix.ldlt().solve(h * (Q + elastic));
}

}  // namespace hair

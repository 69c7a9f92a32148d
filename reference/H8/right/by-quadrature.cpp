// STAFF ONLY. A right solution of H8 that turns frames by quaternions, integrates along the element by
// Gauss's quadrature with a panel for each radian that it winds, and solves by Eigen's conjugate gradients.
// It has no matrix J: it carries motions from the root and forces from the tip.

#include "hair/super_helix.h"

#include <Eigen/IterativeLinearSolvers>
#include <cmath>

namespace hair {
namespace {

using Eigen::Quaterniond;

Quaterniond turn(const Vector3d& angle) {
  const double half = angle.norm() / 2;
  const double part = half < 1e-4 ? 0.5 - half * half / 12 : std::sin(half) / (2 * half);
  return {std::cos(half), part * angle.x(), part * angle.y(), part * angle.z()};
}

// The integral from 0 to s of f, by 6 nodes in each panel.
template <typename Value, typename Integrand>
Value integral(const Vector3d& curvature, double s, const Value& zero, const Integrand& f) {
  const double nodes[] = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
  const double weights[] = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
  const int panels = 2 + static_cast<int>(std::abs(s) * curvature.norm() / 0.5);
  const double half = s / panels / 2;
  Value sum = zero;
  for (int panel = 0; panel < panels; ++panel)
    for (int k = 0; k < 3; ++k)
      for (const int side : {-1, 1}) sum += weights[k] * half * f((2 * panel + 1 + side * nodes[k]) * half);
  return sum;
}

// Carries velocities at these rates over one element, from the root on.
void carry_motion(const HelixElement& element, const Vector3d& rate, Vector3d& velocity, Vector3d& spin) {
  velocity += spin.cross(element.end.position - element.start.position) + element.at_end.moves * rate;
  spin += element.at_end.turns * rate;
}

Eigen::Matrix3Xd velocities(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                            Input rates) {
  Eigen::Matrix3Xd found(3, points.size());
  Vector3d velocity = Vector3d::Zero(), spin = Vector3d::Zero();
  std::size_t j = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Vector3d rate = rates.segment<3>(3 * i);
    for (; j < points.size() && points[j].element == static_cast<int>(i); ++j)
      found.col(j) =
          velocity + spin.cross(points[j].position - elements[i].start.position) + points[j].moves * rate;
    carry_motion(elements[i], rate, velocity, spin);
  }
  return found;
}

// Each point's force acts on its own element, and is carried as a force and a torque about 0 towards the
// root.
template <typename Force>
void carry_forces(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                  const Force& force_of, Output Q) {
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
  std::size_t j = points.size();
  for (std::size_t i = elements.size(); i-- > 0;) {
    const HelixElement& element = elements[i];
    const Vector3d about_end = torque - element.end.position.cross(force);
    Vector3d sum = element.at_end.turns.transpose() * about_end + element.at_end.moves.transpose() * force;
    for (; j > 0 && points[j - 1].element == static_cast<int>(i); --j) {
      const Vector3d f = force_of(j - 1);
      sum += points[j - 1].moves.transpose() * f;
      force += f;
      torque += points[j - 1].position.cross(f);
    }
    Q.segment<3>(3 * i) = sum;
  }
}

}  // namespace

std::array<double, 8> stumpff(double x) {
  std::array<double, 8> c;
  const double a = std::sqrt(x);
  c[0] = std::cos(a);
  c[1] = x > 0 ? std::sin(a) / a : 1;
  for (int k = 2; k < 8; ++k) {
    if (x > 9) {
      c[k] = (1 / std::tgamma(k - 1) - c[k - 2]) / x;
      continue;
    }
    double term = 1 / std::tgamma(k + 1);
    c[k] = 0;
    for (int m = 1; m <= 20; ++m) {
      c[k] += term;
      term = -term * x / ((k + 2 * m - 1) * (k + 2 * m));
    }
  }
  return c;
}

MaterialFrame frame_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const Vector3d e(0, 0, 1);
  const Vector3d along = integral<Vector3d>(curvature, s, Vector3d::Zero(),
                                            [&](double at) -> Vector3d { return turn(at * curvature) * e; });
  return {start.position + start.axes * along, start.axes * turn(s * curvature).toRotationMatrix()};
}

void carry_frames(const MaterialFrame& root, std::vector<HelixElement>& elements) {
  Quaterniond orientation(root.axes);
  Vector3d position = root.position;
  for (HelixElement& element : elements) {
    element.start = {position, orientation.toRotationMatrix()};
    const MaterialFrame beside = frame_at({}, element.curvature, element.length);
    position += orientation * beside.position;
    orientation = (orientation * turn(element.length * element.curvature)).normalized();
    element.end = {position, orientation.toRotationMatrix()};
  }
}

void helix_stiffness(const HelixStrand& strand, Output K) {
  Eigen::Map<Eigen::Matrix3Xd> table(K.data(), 3, strand.elements());
  table.topRows<2>().rowwise() = strand.bend_rigidity * strand.lengths.transpose();
  table.row(2) = strand.twist_rigidity * strand.lengths.transpose();
}

void elastic_force(const HelixStrand& strand, Input q, Output force) {
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const double rigidity = k % 3 == 2 ? strand.twist_rigidity : strand.bend_rigidity;
    force[k] = rigidity * (strand.natural[k] - q[k]) * strand.lengths[k / 3];
  }
}

HelixJacobian jacobian_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const auto axes = [&](double at) -> Matrix3d {
    return start.axes * turn(at * curvature).toRotationMatrix();
  };
  const Vector3d end = frame_at({}, curvature, s).position;
  const auto moved = [&](double at) -> Matrix3d {
    const Vector3d arm = start.axes * (end - frame_at({}, curvature, at).position);
    const Matrix3d n = axes(at);
    Matrix3d columns;
    for (int k = 0; k < 3; ++k) columns.col(k) = n.col(k).cross(arm);
    return columns;
  };
  return {integral<Matrix3d>(curvature, s, Matrix3d::Zero(), axes),
          integral<Matrix3d>(curvature, s, Matrix3d::Zero(), moved)};
}

void generalised_force(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                       Output Q) {
  carry_forces(
      elements, points, [&](std::size_t j) { return points[j].force; }, Q);
}

// Makes a column for each rate: the momenta of the points at this rate, carried back.
void mass_matrix(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                 Eigen::Ref<Eigen::MatrixXd> M) {
  for (Eigen::Index k = 0; k < M.cols(); ++k) {
    const Eigen::Matrix3Xd v = velocities(elements, points, Eigen::VectorXd::Unit(M.cols(), k));
    carry_forces(
        elements, points, [&](std::size_t j) -> Vector3d { return points[j].inertia * v.col(j); }, M.col(k));
  }
}

void helix_step(const HelixStrand& strand, const std::vector<HelixElement>& elements,
                const std::vector<HelixPoint>& points, Input q, Input rates, double h, Scratch scratch,
                Output change) {
  const Eigen::Index size = q.size();
  auto matrix = scratch.leftCols(size);
  auto Q = scratch.col(size), elastic = scratch.col(size + 1), ahead = scratch.col(size + 2);
  mass_matrix(elements, points, matrix);
  helix_stiffness(strand, Q);
  matrix.diagonal() += h * h * Q;
  generalised_force(elements, points, Q);
  ahead = q + h * rates;
  elastic_force(strand, ahead, elastic);
  Eigen::ConjugateGradient<Eigen::MatrixXd, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(1e-13);
  solver.setMaxIterations(50 * size);
  solver.compute(matrix);
  change = solver.solve(h * (Q + elastic));
}

}  // namespace hair

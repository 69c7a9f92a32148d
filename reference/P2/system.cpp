// STAFF ONLY. Draws systems of constraints for the cases of P2, and builds their tables.
#include "reference/P2/system.h"

#include <cmath>

#include "grader/judge/cases/random.h"

namespace grader {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using particles::Rod;
using particles::Wire;

Vector3d at(const VectorXd& vector, int i) {
  return vector.segment<3>(3 * i);
}

Vector3d random_point(Random& random) {
  return {random.normal(), random.normal(), random.normal()};
}

}  // namespace

MatrixXd ConstrainedSystem::jacobian() const {
  MatrixXd J = MatrixXd::Zero(rows(), 3 * n());
  int row = 0;
  for (const Rod& rod : constraints.rods) {
    const Vector3d d = at(state.x, rod.i) - at(state.x, rod.j);
    J.block<1, 3>(row, 3 * rod.i) += d.transpose();
    J.block<1, 3>(row++, 3 * rod.j) -= d.transpose();
  }
  for (const Wire& wire : constraints.wires) {
    J.block<1, 3>(row++, 3 * wire.i) = (at(state.x, wire.i) - wire.centre).transpose();
    J.block<1, 3>(row++, 3 * wire.i) = wire.normal.transpose();
  }
  return J;
}

VectorXd ConstrainedSystem::inverse_masses() const {
  VectorXd W(3 * n());
  for (int i = 0; i < n(); ++i)
    W.segment<3>(3 * i).setConstant(particles.is_pinned(i) ? 0 : 1 / particles.mass[i]);
  return W;
}

MatrixXd ConstrainedSystem::matrix() const {
  return jacobian() * inverse_masses().asDiagonal() * jacobian().transpose();
}

VectorXd ConstrainedSystem::values() const {
  VectorXd C(rows());
  int row = 0;
  for (const Rod& rod : constraints.rods)
    C[row++] = ((at(state.x, rod.i) - at(state.x, rod.j)).squaredNorm() - rod.length * rod.length) / 2;
  for (const Wire& wire : constraints.wires) {
    const Vector3d d = at(state.x, wire.i) - wire.centre;
    C[row++] = (d.squaredNorm() - wire.radius * wire.radius) / 2;
    C[row++] = d.dot(wire.normal);
  }
  return C;
}

VectorXd ConstrainedSystem::curvature() const {
  VectorXd sum(rows());
  int row = 0;
  for (const Rod& rod : constraints.rods)
    sum[row++] = (at(state.v, rod.i) - at(state.v, rod.j)).squaredNorm();
  for (const Wire& wire : constraints.wires) {
    sum[row++] = at(state.v, wire.i).squaredNorm();
    sum[row++] = 0;
  }
  return sum;
}

VectorXd ConstrainedSystem::right_hand_side() const {
  const MatrixXd J = jacobian();
  return -curvature() - J * inverse_masses().cwiseProduct(f) - constraints.stiffness * values() -
         constraints.damping * J * state.v;
}

double ConstrainedSystem::matrix_size() const {
  const MatrixXd J = jacobian().cwiseAbs();
  return (J * inverse_masses().asDiagonal() * J.transpose()).norm();
}

double ConstrainedSystem::value_size() const {
  double squared = 0;
  for (const Rod& rod : constraints.rods)
    squared += std::pow((at(state.x, rod.i).norm() + at(state.x, rod.j).norm()) *
                                (at(state.x, rod.i) - at(state.x, rod.j)).norm() +
                            rod.length * rod.length,
                        2);
  for (const Wire& wire : constraints.wires) {
    const double far = at(state.x, wire.i).norm() + wire.centre.norm();
    squared +=
        std::pow(far * (1 + (at(state.x, wire.i) - wire.centre).norm()) + wire.radius * wire.radius, 2);
  }
  return std::sqrt(squared);
}

double ConstrainedSystem::right_hand_side_size() const {
  const MatrixXd J = jacobian().cwiseAbs();
  return curvature().norm() + (J * inverse_masses().cwiseProduct(f.cwiseAbs())).norm() +
         constraints.stiffness * value_size() + constraints.damping * (J * state.v.cwiseAbs()).norm();
}

double ConstrainedSystem::residual_rounding(const VectorXd& lambda) const {
  // A particle's own sum has a term for each constraint on it.
  const double product_error = 16 + rows();
  return kUnit *
         (32 * right_hand_side_size() + (2 * product_error + 64 * (10 + 2 * product_error)) * matrix_size() *
                                            (2 * lambda.norm() + right_hand_side().norm()));
}

ConstrainedSystem random_chain(Random& random, int n) {
  ConstrainedSystem system;
  system.name = "chain of " + std::to_string(n);
  system.particles.mass.resize(n);
  system.particles.pinned.assign(n, 0);
  system.state = {VectorXd(3 * n), VectorXd(3 * n)};
  system.f.resize(3 * n);
  Vector3d place = random_point(random);
  for (int i = 0; i < n; ++i) {
    system.particles.mass[i] = random.log_uniform(0.1, 10);
    system.state.x.segment<3>(3 * i) = place;
    system.state.v.segment<3>(3 * i) = random_point(random);
    system.f.segment<3>(3 * i) = 5 * random_point(random);
    const Vector3d direction = random_point(random).normalized();
    place += direction * random.uniform(0.7, 1.3);
  }
  for (int i = 0; i + 1 < n; ++i) {
    // Either end may come first.
    const bool turned = random.integer(0, 1) == 1;
    system.constraints.rods.push_back({turned ? i + 1 : i, turned ? i : i + 1, random.uniform(0.7, 1.3)});
  }
  return system;
}

void add_wire(Random& random, ConstrainedSystem& system, int i) {
  const Vector3d direction = random_point(random).normalized();
  const Vector3d centre = at(system.state.x, i) + direction * random.uniform(0.5, 2);
  // The normal stands across the radius, but for some tenths.
  const Vector3d normal = (at(system.state.x, i) - centre).cross(random_point(random)).normalized();
  system.constraints.wires.push_back(
      {i, centre, (normal + 0.1 * random_point(random)).normalized(), random.uniform(0.5, 2)});
}

ConstrainedSystem held(ConstrainedSystem system) {
  for (Rod& rod : system.constraints.rods)
    rod.length = (at(system.state.x, rod.i) - at(system.state.x, rod.j)).norm();
  for (Wire& wire : system.constraints.wires) {
    const Vector3d d = at(system.state.x, wire.i) - wire.centre;
    wire.normal = (wire.normal - wire.normal.dot(d) / d.squaredNorm() * d).normalized();
    wire.radius = d.norm();
  }
  return system;
}

ConstrainedSystem at_rest(ConstrainedSystem system) {
  system.state.v.setZero();
  return system;
}

std::vector<ConstrainedSystem> chains(Random& random) {
  std::vector<ConstrainedSystem> systems;
  for (int n : {2, 3, random.integer(5, 8), random.integer(9, 15)})
    systems.push_back(random_chain(random, n));
  return systems;
}

ConstrainedSystem separate_rods(Random& random, int rods) {
  ConstrainedSystem system = random_chain(random, 2 * rods);
  system.name = "separate rods";
  system.particles.mass.setConstant(random.uniform(2, 5));
  for (int i = rods - 1; i-- > 0;) system.constraints.rods.erase(system.constraints.rods.begin() + 2 * i + 1);
  return system;
}

std::vector<ConstrainedSystem> beads(Random& random) {
  std::vector<ConstrainedSystem> systems;
  for (int n : {1, 2, 4}) {
    systems.push_back(random_chain(random, n));
    systems.back().name = "beads";
    systems.back().constraints.rods.clear();
    for (int i = n - 1; i >= 0; --i) add_wire(random, systems.back(), (i + 1) % n);
  }
  return systems;
}

std::vector<ConstrainedSystem> hung_chains(Random& random) {
  std::vector<ConstrainedSystem> systems;
  for (int n : {2, 3, random.integer(5, 8)}) {
    systems.push_back(random_chain(random, n));
    systems.back().name = "hung chain";
    add_wire(random, systems.back(), n - 1);
    add_wire(random, systems.back(), 0);
  }
  return systems;
}

ConstrainedSystem rigid_body(Random& random, int n) {
  ConstrainedSystem body = random_chain(random, n);
  body.name = "rigid body";
  body.constraints = {};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) body.constraints.rods.push_back({i, j, 1});
  return held(body);
}

}  // namespace grader

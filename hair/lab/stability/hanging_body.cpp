#include "hair/lab/stability/hanging_body.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "hair/io/files/bad_input.h"
#include "hair/lab/stability/theory.h"
#include "hair/simulation/models.h"
#include "hair/strand/rest_shape.h"
#include "hair/strand/variation.h"
#include "solver/symmetric_eigen.h"

namespace hair {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr int kRoot = 3;  // coordinates of the root
// rad, the disturbance's turn of an element: angles a about two axes across turn it by a^2/2 about itself,
// which must stay small compared with its twist, at most a ten-thousandth of a.
constexpr double kLargestAngle = 1e-6;
constexpr double kSmall = 1e-4;       // rad: energies are quadratic to 1e-8, and rounding errors are as large
constexpr double kLeastPart = 1e-12;  // part of the fastest square frequency: smaller ones are rounding

Description alone(const Description& hair, const ModelledStrand& strand) {
  Description one = hair;
  one.strands.clear();
  one.modelled = {strand};
  one.obstacles.clear();
  one.wind.setZero();
  return one;
}

// The matrix of the second derivatives of f at 0.
template <typename Function>
MatrixXd second_derivatives(Index n, double step, const Function& f) {
  MatrixXd matrix(n, n);
  VectorXd at = VectorXd::Zero(n);
  const auto value = [&](Index i, double a, Index j, double b) {
    at[i] += a * step;
    at[j] += b * step;
    const double result = f(at);
    at[i] = at[j] = 0;
    return result;
  };
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j <= i; ++j)
      matrix(i, j) = matrix(j, i) =
          (value(i, 1, j, 1) - value(i, 1, j, -1) - value(i, -1, j, 1) + value(i, -1, j, -1)) /
          (4 * step * step);
  return matrix;
}

MatrixXd stiffness_of(const Body& body, const VectorXd& rest) {
  const VectorXd still = VectorXd::Zero(rest.size());
  VectorXd q = rest;
  return second_derivatives(rest.size() - kRoot, kSmall, [&](const VectorXd& change) {
    q.tail(change.size()) = rest.tail(change.size()) + change;
    return body.measure(q, still).potential;
  });
}

MatrixXd inertia_of(const Body& body, const VectorXd& rest) {
  VectorXd rates = VectorXd::Zero(rest.size());
  return second_derivatives(rest.size() - kRoot, 1, [&](const VectorXd& change) {
    rates.tail(change.size()) = change;
    return body.measure(rest, rates).kinetic;
  });
}

// The integral of v^2 along the line, m^3/s^2, with velocities linear between its points.
double squares_along(const Body& body, const VectorXd& rest, const VectorXd& rates) {
  VectorXd x(3 * body.points()), v(x.size());
  body.centre_line(rest, rates, x, v);
  double sum = 0;
  for (Index k = 3; k < x.size(); k += 3) {
    const Vector3d from = v.segment<3>(k - 3), to = v.segment<3>(k);
    sum += (x.segment<3>(k) - x.segment<3>(k - 3)).norm() / 3 *
           (from.squaredNorm() + from.dot(to) + to.squaredNorm());
  }
  return sum;
}

VectorXd with_root(const VectorXd& others) {
  VectorXd all = VectorXd::Zero(others.size() + kRoot);
  all.tail(others.size()) = others;
  return all;
}

Modes modes_of(const MatrixXd& inertia, MatrixXd stiffness) {
  const Eigen::LLT<MatrixXd> factor(inertia);
  const MatrixXd half = factor.matrixL().solve(stiffness);
  const solver::SymmetricEigen eigen = solver::symmetric_eigen(factor.matrixL().solve(half.transpose()));
  return {std::move(stiffness), eigen.values.cwiseMax(0).cwiseSqrt(), factor.matrixU().solve(eigen.vectors)};
}

}  // namespace

double HangingBody::fastest_with_drag(bool has_drag) const {
  double fastest = 0;
  for (Index i = 0; i < modes.omega.size(); ++i)
    if ((drag_per_mass[i] > drag_per_mass.maxCoeff() / 2) == has_drag)
      fastest = std::max(fastest, modes.omega[i]);
  return fastest;
}

HangingBody hang_body(const Description& hair, double stiffness) {
  HangingBody hanging{hair.modelled.at(0), 0, 0, {}, {}, {}, {}, {}};
  StrandSpec& spec = hanging.strand.spec;
  if (!spec.clamped) throw BadInput("nothing brings its strand back when it turns about itself; clamp it");
  spec.form = Straight{};
  spec.start = {};
  spec.root_velocity.setZero();
  spec.root.position.setZero();
  const bool falls = hair.gravity != Vector3d::Zero();
  spec.root.axis = falls ? Vector3d(hair.gravity.normalized()) : Vector3d(0, 0, -1);
  spec.root.side = side_of(spec.root.axis);
  spec.fibre.material.young_modulus *= stiffness;
  spec.fibre.material.shear_modulus *= stiffness;
  spec.fibre.relaxation_time = 0;
  hanging.length = spec.length;
  hanging.mass = spec.length * spec.fibre.material.line_density();

  Description description = alone(hair, hanging.strand);
  const std::unique_ptr<Body> body = hanging.strand.model->make(spec, description);
  description.gravity.setZero();
  const std::unique_ptr<Body> weightless = hanging.strand.model->make(spec, description);
  hanging.rest.resize(body->size());
  VectorXd rates(body->size());
  body->read(hanging.rest, rates);

  hanging.inertia = inertia_of(*body, hanging.rest);
  hanging.modes = modes_of(hanging.inertia, stiffness_of(*body, hanging.rest));
  const VectorXd squares = hanging.modes.omega.cwiseAbs2();
  if (!(squares.minCoeff() > kLeastPart * squares.maxCoeff()))
    throw BadInput("nothing brings its strand back when it swings; give it \"gravity\", or a stiffer fibre");
  const MatrixXd& shape = hanging.modes.shape;
  hanging.elastic = shape.transpose() * stiffness_of(*weightless, hanging.rest) * shape;
  hanging.drag_per_mass.resize(shape.cols());
  for (Index i = 0; i < shape.cols(); ++i)
    hanging.drag_per_mass[i] = squares_along(*body, hanging.rest, with_root(shape.col(i)));
  return hanging;
}

BodyDisturbance disturb(const HangingBody& hanging) {
  const Modes& modes = hanging.modes;
  const double speed = kLargestAngle / (modes.shape.cwiseAbs() * modes.omega.cwiseInverse()).maxCoeff();
  VectorXd signs(modes.omega.size());
  Variation variation(1);
  for (double& sign : signs) sign = variation.uniform(-1, 1) < 0 ? -1 : 1;
  return {with_root(speed * (modes.shape * signs)), speed * speed / 2};
}

Outcome run_disturbed(const Description& hair, const HangingBody& hanging, const BodyDisturbance& disturbance,
                      double drag, double h, long steps) {
  Description description = alone(hair, hanging.strand);
  description.drag = drag;
  description.step = h;
  Simulation simulation(std::move(description));
  Body& body = simulation.body(0);
  body.write(hanging.rest, disturbance.rates);

  const Modes& modes = hanging.modes;
  const Index n = modes.omega.size();
  const MatrixXd to_modes = modes.shape.transpose() * hanging.inertia;
  const double most_kinetic = std::max(2 * hanging.mass * hair.gravity.norm() * hanging.length,
                                       1e6 * disturbance.energy_of_mode * static_cast<double>(n));
  VectorXd q(hanging.rest.size()), rates(q.size());
  return observed(simulation, steps, [&](Judge& judge) {
    body.read(q, rates);
    const Eigen::ArrayXd x = (to_modes * (q - hanging.rest).tail(n)).array() * modes.omega.array(),
                         v = to_modes * rates.tail(n);
    double true_mean = 0;
    for (Index i = 0; i < n; ++i)
      true_mean += oscillator_energy(modes.omega[i], hanging.drag_per_mass[i] * drag, simulation.time()) /
                   static_cast<double>(n);
    const VectorXd energies = (x.square() + v.square()) / (2 * disturbance.energy_of_mode);
    return judge.look(energies, body.measure(q, rates).kinetic / most_kinetic, true_mean);
  });
}

double limit_of(Method method, const HangingBody& hanging, double drag, double growth) {
  const VectorXd& omega = hanging.modes.omega;
  const VectorXd gamma = drag * hanging.drag_per_mass;
  if (!row_of(method).is_explicit)
    return implicit_limit(VectorXd::Ones(omega.size()), omega.cwiseAbs2().asDiagonal(), hanging.elastic,
                          gamma.maxCoeff(), growth);
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < omega.size(); ++i)
    least = std::min(least, explicit_limit(method, {omega[i], gamma[i]}, growth));
  return least;
}

double fastest_by_weight(const HangingBody& hanging) {
  const Index n = hanging.elastic.rows();
  MatrixXd weight = -hanging.elastic;
  weight.diagonal() += hanging.modes.omega.cwiseAbs2();
  const double limit = implicit_limit(VectorXd::Ones(n), weight, MatrixXd::Zero(n, n), 0);
  return std::isfinite(limit) ? 2 / limit : hanging.fastest();
}

}  // namespace hair

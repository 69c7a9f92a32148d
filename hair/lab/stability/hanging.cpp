#include "hair/lab/stability/hanging.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "hair/io/files/bad_input.h"
#include "hair/lab/stability/theory.h"
#include "hair/scene/roots.h"
#include "hair/strand/variation.h"
#include "particles/force.h"
#include "solver/dense_algebra.h"

namespace hair {

namespace {

constexpr double kOfTension = 0.01;    // the part of a segment's tension that the disturbance may add or take
constexpr double kLargestTurn = 1e-3;  // rad, the strand's turn by the disturbance
constexpr double kSlackStrain = 1e-9;  // for segments without tension
constexpr double kAboveRounding = 100 * std::numeric_limits<double>::epsilon();

// -df/dx between all free particles, in one direction each.
Eigen::MatrixXd stiffness_in(const particles::Force& force, const particles::State& state,
                             const Vector3d& direction) {
  const Eigen::Index n = state.x.size() / 3;
  Eigen::MatrixXd matrix(n - 1, n - 1);
  Eigen::VectorXd dx = Eigen::VectorXd::Zero(3 * n), df(3 * n);
  for (Eigen::Index j = 1; j < n; ++j) {
    dx.segment<3>(3 * j) = direction;
    df.setZero();
    force.add_dfdx(state.x, state.v, dx, df);
    dx.segment<3>(3 * j).setZero();
    for (Eigen::Index i = 1; i < n; ++i) matrix(i - 1, j - 1) = -df.segment<3>(3 * i).dot(direction);
  }
  return (matrix + matrix.transpose()) / 2;
}

Modes modes_of(const Eigen::VectorXd& mass, Eigen::MatrixXd stiffness) {
  const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
  const solver::SymmetricEigen eigen =
      solver::symmetric_eigen(scale.asDiagonal() * stiffness * scale.asDiagonal());
  return {std::move(stiffness), eigen.values.cwiseMax(0).cwiseSqrt(), scale.asDiagonal() * eigen.vectors};
}

Description with_products(const Description& hair, const StrandStart& start, GeometricTerm term,
                          Products product) {
  Description one = hair;
  one.strands = {start};
  one.obstacles.clear();
  one.wind.setZero();
  one.drag = 0;
  one.geometric_term = term;
  one.bend_product = product;
  return one;
}

// The largest change of each segment, with all modes at once at an energy of 1/2 J each. The root does not
// move.
Eigen::VectorXd most_of(const Modes& modes) {
  Eigen::MatrixXd changes = modes.shape;
  changes.bottomRows(changes.rows() - 1) -= modes.shape.topRows(changes.rows() - 1);
  return changes.cwiseAbs() * modes.omega.cwiseInverse();
}

}  // namespace

double Hanging::fastest() const {
  return std::max(along_modes.omega.maxCoeff(), across_modes.omega.maxCoeff());
}

Hanging hang(const Description& hair, double stiffness, bool keeps_lengths) {
  Hanging hanging;
  hanging.keeps_lengths = keeps_lengths;
  StrandStart& start = hanging.start;
  start = hair.strands.at(0);
  start.rest_curvature.resize(0);
  Strand& strand = start.strand;
  if (strand.segments() == 0)
    throw BadInput("a strand of one particle does not move; give one with segments");
  strand.stretch_rigidity *= stiffness;
  strand.bend_rigidity *= stiffness;
  strand.skip_rigidity *= stiffness;
  const bool falls = hair.gravity != Vector3d::Zero();
  hanging.down = falls ? Vector3d(hair.gravity.normalized()) : Vector3d(0, 0, -1);
  hanging.across = side_of(hanging.down);
  strand.root_tangent = hanging.down;
  const int n = strand.count();
  hanging.mass = strand.mass.tail(n - 1);
  // Drag and mass are divided among particles in the same way (force_parts.cpp).
  hanging.drag_per_mass = strand.rest_length[n - 2] / 2 / strand.mass[n - 1];

  particles::State& state = start.state;
  state.x = state.v = Eigen::VectorXd::Zero(3 * n);
  for (int i = 1; i < n; ++i)
    state.x.segment<3>(3 * i) = state.x.segment<3>(3 * i - 3) + strand.rest_length[i - 1] * hanging.down;
  const particles::State at_rest_lengths = state;

  const Simulation simulation(with_products(hair, start, GeometricTerm::full, Products::exact));
  const particles::Force& force = simulation.force(0);
  // Straight springs in a line are linear: the second step removes the first one's rounding errors.
  for (int k = 0; k < 2; ++k) {
    const Eigen::LDLT<Eigen::MatrixXd> solver(stiffness_in(force, state, hanging.down));
    const Eigen::VectorXd pivots = solver.vectorD();
    if (!(pivots.minCoeff() > 1e-12 * pivots.maxCoeff()))
      throw BadInput(
          "its strand has nothing that holds it against its weight; give one with a \"stretch_factor\" above "
          "0");
    Eigen::VectorXd f = Eigen::VectorXd::Zero(3 * n), pull(n - 1);
    force.add_force(state.x, state.v, f);
    for (int i = 1; i < n; ++i) pull[i - 1] = f.segment<3>(3 * i).dot(hanging.down);
    const Eigen::VectorXd moved = solver.solve(pull);
    for (int i = 1; i < n; ++i) state.x.segment<3>(3 * i) += moved[i - 1] * hanging.down;
  }
  hanging.along_modes = modes_of(hanging.mass, stiffness_in(force, state, hanging.down));
  hanging.across_modes = modes_of(hanging.mass, stiffness_in(force, state, hanging.across));
  const Eigen::VectorXd squares = hanging.across_modes.omega.cwiseAbs2();
  if (!(squares.minCoeff() > kAboveRounding * squares.maxCoeff()))
    throw BadInput(
        "nothing brings its strand back when it swings; give it \"gravity\", or clamp a strand that bends");
  if (keeps_lengths) state = at_rest_lengths;
  return hanging;
}

ProductParts products_of(const Description& hair, const Hanging& hanging, GeometricTerm term,
                         Products product) {
  const Simulation simulation(with_products(hair, hanging.start, term, product));
  const particles::State& state = hanging.start.state;
  return {stiffness_in(simulation.force(0), state, hanging.down),
          stiffness_in(simulation.force(0), state, hanging.across)};
}

double fastest_by_tension(const Description& hair, const Hanging& hanging) {
  const ProductParts products = products_of(hair, hanging, GeometricTerm::dropped, Products::exact);
  const double limit = implicit_limit(hanging.mass, hanging.across_modes.stiffness - products.across,
                                      Eigen::MatrixXd::Zero(hanging.mass.size(), hanging.mass.size()), 0);
  return std::isfinite(limit) ? 2 / limit : hanging.across_modes.omega.maxCoeff();
}

Disturbance disturb(const Hanging& hanging) {
  const Strand& strand = hanging.start.strand;
  const int n = strand.count();
  const Eigen::VectorXd turns = most_of(hanging.across_modes).cwiseQuotient(strand.rest_length);
  // sqrt(kg) m/s, the same for every mode: a mode's energy is half the square.
  double speed = kLargestTurn / turns.maxCoeff();
  if (!hanging.keeps_lengths) {
    const Eigen::VectorXd strains = most_of(hanging.along_modes).cwiseQuotient(strand.rest_length);
    double along = speed;
    for (int i = n - 2; i >= 0; --i) {
      const double length =
          (hanging.start.state.x.segment<3>(3 * i + 3) - hanging.start.state.x.segment<3>(3 * i)).norm();
      const double strain = length / strand.rest_length[i] - 1;
      along = std::min(along, std::max(kOfTension * strain, kOfTension * kSlackStrain) / strains[i]);
    }
    // The fastest mode's displacement must exceed the rounding of positions.
    const double way = hanging.along_modes.shape.cwiseAbs().maxCoeff() / hanging.along_modes.omega.maxCoeff();
    speed = std::min(speed, std::max(along, kAboveRounding * strand.rest_length.sum() / way));
  }
  Disturbance disturbance{hanging.start.state, speed * speed / 2, 0};
  Variation variation(1);
  const auto add = [&](const Modes& modes, const Vector3d& direction) {
    Eigen::VectorXd signs(n - 1);
    for (double& sign : signs) sign = variation.uniform(-1, 1) < 0 ? -1 : 1;
    const Eigen::VectorXd v = speed * (modes.shape * signs);
    for (int i = 1; i < n; ++i) disturbance.state.v.segment<3>(3 * i) += v[i - 1] * direction;
    disturbance.modes += n - 1;
  };
  add(hanging.across_modes, hanging.across);
  if (!hanging.keeps_lengths) add(hanging.along_modes, hanging.down);
  return disturbance;
}

}  // namespace hair

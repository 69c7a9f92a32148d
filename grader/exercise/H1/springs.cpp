// STAFF ONLY. H1's requests, comparisons and bounds.
#include "grader/exercise/H1/springs.h"

#include <cmath>

#include "grader/exercise/H1/calls.h"
#include "hair/stretch_springs.h"

namespace grader::h1 {

using Eigen::Vector3d;

namespace {

double length(const Posed& posed, int i) {
  return (posed.x.segment<3>(3 * i + 3) - posed.x.segment<3>(3 * i)).norm();
}

double stiffness(const Strand& strand, int i) {
  return strand.stretch_rigidity / strand.rest_length[i];
}

}  // namespace

double ask_energy(Trial& trial, const Posed& posed) {
  return energy_of<Calls, hair::stretch_energy>(trial, posed);
}

VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before) {
  return sum_of<Calls, hair::add_stretch_force>(trial, posed, "a force", before);
}

VectorXd ask_force(Trial& trial, const Posed& posed) {
  return ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     GeometricTerm term) {
  return sum_of<Calls, hair::add_stretch_product>(trial, posed, "a product", before, term, dx);
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, GeometricTerm term) {
  return ask_product(trial, posed, dx, VectorXd::Zero(dx.size()), term);
}

double energy_rounding(const Posed& posed) {
  double rounding = kUnit * posed.strand.segments() * hair::stretch_energy(posed.strand, posed.x);
  for (int i = 0; i < posed.strand.segments(); ++i) {
    const double l = length(posed, i), l0 = posed.strand.rest_length[i];
    rounding += 64 * kUnit * stiffness(posed.strand, i) * (std::abs(l - l0) + 64 * kUnit * l0) * (l + l0);
    rounding += 4 * kUnit * stiffness(posed.strand, i) * (l + l0) * (l + l0);
  }
  return rounding;
}

void expect_energy(Trial& trial, const Posed& posed) {
  const double error = ask_energy(trial, posed) - hair::stretch_energy(posed.strand, posed.x);
  trial.expect_at_most(std::abs(error), energy_rounding(posed), "the error of the energy");
}

double force_rounding(const Posed& posed) {
  double most = 0;
  for (int i = 0; i < posed.strand.segments(); ++i)
    most = std::max(most, stiffness(posed.strand, i) * (length(posed, i) + posed.strand.rest_length[i]));
  return 128 * kUnit * most;
}

void expect_force(Trial& trial, const Posed& posed) {
  VectorXd expected = VectorXd::Zero(posed.x.size());
  hair::add_stretch_force(posed.strand, posed.x, expected);
  expect_vector(trial, ask_force(trial, posed), expected, force_rounding(posed), "the force");
}

double product_rounding(const Posed& posed, const VectorXd& dx) {
  double most = 0;
  for (int i = 0; i < posed.strand.segments(); ++i) {
    const double l = length(posed, i);
    const Vector3d de = dx.segment<3>(3 * i + 3) - dx.segment<3>(3 * i);
    if (l > 0)
      most = std::max(most, stiffness(posed.strand, i) * (1 + posed.strand.rest_length[i] / l) * de.norm());
  }
  return 128 * kUnit * most;
}

void expect_product(Trial& trial, const Posed& posed, GeometricTerm term) {
  const VectorXd dx = random_vector(trial.random, posed.x.size());
  VectorXd expected = VectorXd::Zero(dx.size());
  hair::add_stretch_product(posed.strand, posed.x, term, dx, expected);
  expect_vector(trial, ask_product(trial, posed, dx, term), expected, product_rounding(posed, dx),
                "the product");
}

}  // namespace grader::h1

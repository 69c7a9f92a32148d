// STAFF ONLY. H3's requests, comparisons and bounds.
#include "grader/exercise/H3/springs.h"

#include <cmath>

#include "grader/exercise/H3/calls.h"
#include "hair/bend_springs.h"

namespace grader::h3 {
namespace {

struct Spring {
  double stiffness, rest, distance;
};

Spring spring(const Posed& posed, int i) {
  const double rest = posed.strand.rest_length[i] + posed.strand.rest_length[i + 1];
  return {posed.strand.skip_rigidity / rest, rest,
          (posed.x.segment<3>(3 * i + 6) - posed.x.segment<3>(3 * i)).norm()};
}

}  // namespace

double ask_energy(Trial& trial, const Posed& posed) {
  return energy_of<Calls, hair::bend_spring_energy>(trial, posed);
}

VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before) {
  return sum_of<Calls, hair::add_bend_spring_force>(trial, posed, "a force", before);
}

VectorXd ask_force(Trial& trial, const Posed& posed) {
  return ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     GeometricTerm term) {
  return sum_of<Calls, hair::add_bend_spring_product>(trial, posed, "a product", before, term, dx);
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, GeometricTerm term) {
  return ask_product(trial, posed, dx, VectorXd::Zero(dx.size()), term);
}

double energy_rounding(const Posed& posed) {
  double rounding = kUnit * posed.strand.count() * hair::bend_spring_energy(posed.strand, posed.x);
  for (int i = 0; i + 2 < posed.strand.count(); ++i) {
    const auto [k, d0, d] = spring(posed, i);
    rounding += 64 * kUnit * k * (std::abs(d - d0) + 64 * kUnit * d0) * (d + d0);
    rounding += 4 * kUnit * k * (d + d0) * (d + d0);
  }
  return rounding;
}

void expect_energy(Trial& trial, const Posed& posed) {
  const double error = ask_energy(trial, posed) - hair::bend_spring_energy(posed.strand, posed.x);
  trial.expect_at_most(std::abs(error), energy_rounding(posed), "the error of the energy");
}

VectorXd reference_force(const Posed& posed) {
  VectorXd f = VectorXd::Zero(posed.x.size());
  hair::add_bend_spring_force(posed.strand, posed.x, f);
  return f;
}

double force_rounding(const Posed& posed) {
  double most = 0;
  for (int i = 0; i + 2 < posed.strand.count(); ++i) {
    const auto [k, d0, d] = spring(posed, i);
    most = std::max(most, k * (d + d0));
  }
  return 128 * kUnit * most;
}

void expect_force(Trial& trial, const Posed& posed) {
  expect_vector(trial, ask_force(trial, posed), reference_force(posed), force_rounding(posed), "the force");
}

double product_rounding(const Posed& posed, const VectorXd& dx) {
  double most = 0;
  for (int i = 0; i + 2 < posed.strand.count(); ++i) {
    const auto [k, d0, d] = spring(posed, i);
    if (d > 0) most = std::max(most, k * (1 + d0 / d));
  }
  return 128 * kUnit * most * 4 * largest(dx);
}

VectorXd reference_product(const Posed& posed, const VectorXd& dx, GeometricTerm term) {
  VectorXd df = VectorXd::Zero(dx.size());
  hair::add_bend_spring_product(posed.strand, posed.x, term, dx, df);
  return df;
}

void expect_product(Trial& trial, const Posed& posed, GeometricTerm term) {
  const VectorXd dx = random_vector(trial.random, posed.x.size());
  expect_vector(trial, ask_product(trial, posed, dx, term), reference_product(posed, dx, term),
                product_rounding(posed, dx), "the product");
}

Strand half_metres(Random& random, int count) {
  Strand strand = toy_strand(random, count);
  strand.rest_length.setConstant(0.5);
  return strand;
}

}  // namespace grader::h3

// STAFF ONLY. Strands and states for the tests of the forces of H1, H2 and H3, and the properties that all of
// these forces must have.
#pragma once

#include <string>
#include <vector>

#include "hair/strand.h"
#include "handout/check/derivative.h"
#include "solver/test_numbers.h"

namespace reference_tests {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::Strand;

struct StrandState {
  std::string name;
  Strand strand;
  VectorXd x;
  double shortest;        // m: the length of the shortest segment, or less
  double least_bend = 3;  // radians from the fold: a lower bound for all joints
};

// EA = 25 N, EI = 4 N m^2, skip 9 N; masses from 1e-3 to 2 kg, rest lengths from 0.5 to 1.5 m, all different.
Strand test_strand(int count);

// Random, stretched, compressed, nearly folded, collinear, at rest, compressed to 1 %; hinged and clamped.
std::vector<StrandState> strand_states();

// A force without its strand: the functions that the tests of any force need.
struct ForceUnderTest {
  checks::Energy energy;
  checks::Field force;
  std::function<VectorXd(const VectorXd& x, const VectorXd& dx)> product;
};

// The matrix of `product` at x, column by column.
MatrixXd matrix_of(const checks::Operator& product, Eigen::Index size);

// f = -dE/dx and df = f'(x) dx by central differences with steps of 2^-14 of `length`, within 1e-6 of the
// largest entry. If that is smaller, within 2^-36 of `scale` (N, N/m), the error of the differences of 0.
void expect_derivatives(const ForceUnderTest& f, const VectorXd& x, double length, double scale,
                        double product_scale);

// Linear and angular momentum are conserved: sums of forces and torques vanish within `rounding` (N).
void expect_no_momentum(const VectorXd& force, const VectorXd& x, double rounding);

// ||K - K'|| <= rounding, entry by entry.
void expect_symmetric_matrix(const MatrixXd& K, double rounding);

// Rotates x about an axis through the origin, and shifts it.
struct RigidMotion {
  Eigen::Matrix3d rotation;
  Vector3d shift;

  VectorXd points(const VectorXd& x) const;
  VectorXd vectors(const VectorXd& f) const;
};
RigidMotion some_motion();

}  // namespace reference_tests

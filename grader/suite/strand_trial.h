// STAFF ONLY. What the hidden cases of H1, H2 and H3 share: a student's force of a strand, asked across the
// pipe; the strands and states that it is asked about; its answers beside the reference's.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "grader/suite/random_vector.h"
#include "grader/suite/rounding.h"
#include "grader/suite/trial.h"
#include "hair/geometric_term.h"
#include "hair/strand.h"

namespace grader {

using Eigen::VectorXd;
using hair::GeometricTerm;
using hair::Strand;

// A strand where it is.
struct Posed {
  Strand strand;
  VectorXd x;
  std::string name;  // for staff
};

// The functions of an exercise, by their number in strand_call.h. Each checks that an answer is finite.
inline constexpr int kProduct = 2, kSpdProduct = 3;
double ask_energy(Trial& trial, const Posed& posed);
VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before);
VectorXd ask_force(Trial& trial, const Posed& posed);  // from zeros
VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     GeometricTerm term = GeometricTerm::full, int function = kProduct);
VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx,
                     GeometricTerm term = GeometricTerm::full, int function = kProduct);

// The largest entry's size.
double largest(const VectorXd& v);

// No entry is off by more than `bound`.
void expect_vector(Trial& trial, const VectorXd& actual, const VectorXd& expected, double bound,
                   const std::string& what);

// Between a hundredth and a hundred times of what it should be: for cases that ask for a property, so that
// zeros don't have it, and another mistake does not cost it.
void expect_size(Trial& trial, double actual, double expected, const std::string& what);

// Numbers that differ by no more than `relative` of the largest.
void expect_all_equal(Trial& trial, const std::vector<double>& values, double relative,
                      const std::string& what);

// Rest lengths of 1 m, masses and rigidities drawn, none of them 1; a hinge at the root.
Strand toy_strand(Random& random, int count);

struct Range {
  double low, high;
};

// A random pose: segments are `stretch` times their rest length, each turned from the one before by an angle
// in `bend` about an axis without preference. The root, and the first direction (root_tangent if clamped,
// turned likewise), are drawn.
Posed random_pose(Random& random, const Strand& strand, Range stretch, Range bend, const std::string& name);

// On a line through the root: segments of the lengths given, along `direction`.
Posed straight_pose(const Strand& strand, const VectorXd& lengths, const Eigen::Vector3d& direction,
                    const std::string& name);

Eigen::Vector3d random_direction(Random& random);

}  // namespace grader

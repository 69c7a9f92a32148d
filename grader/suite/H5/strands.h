// STAFF ONLY. What H5's hidden cases correct: strands, their states, and how wrong these are.
#pragma once

#include <Eigen/Core>

#include "grader/suite/random_vector.h"
#include "grader/suite/rounding.h"
#include "hair/strand.h"

namespace grader::h5 {

using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::Strand;

// n particles whose masses lie within a factor of `ratio`, segments of about 1 cm.
Strand random_strand(Random& random, int n, double ratio);

// At rest lengths, each segment turned against the one before by about `bend`.
VectorXd placed(Random& random, const Strand& strand, double bend);

// The same with every particle but the root off by about `size` of a segment.
VectorXd disturbed(Random& random, VectorXd x, double size);

// Over the segments, NaN if there is one: | |x_i+1 - x_i| - l0 | / l0, and the velocity at which a segment is
// stretched.
double largest_error(const Strand& strand, const VectorXd& x);
double largest_rate(const Strand& strand, const VectorXd& x, const VectorXd& v);

// sqrt(sum m |dx|^2), what a correction has moved.
double moved(const Strand& strand, const VectorXd& from, const VectorXd& to);

// Rounding of a length beside a rest length: of the coordinates, of their differences and of the norm.
double rounding(const VectorXd& x, double length);

}  // namespace grader::h5

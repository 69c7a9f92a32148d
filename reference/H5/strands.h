// STAFF ONLY. Inputs of H5's hidden cases: strands, their states, and the size of their errors.
#pragma once

#include <Eigen/Core>

#include "grader/judge/cases/random_vector.h"
#include "grader/judge/cases/rounding.h"
#include "hair/strand.h"

namespace grader::h5 {

using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::Strand;

// n particles with masses within a factor of `ratio`, and segments of about, but not exactly, 1 m, so that an
// error in metres meets a tolerance nearly as well as the relative one. The root is so heavy that impulses do
// not move it, even if a program does not hold it. Both mistakes have categories of their own.
Strand random_strand(Random& random, int n, double ratio);

// Positions with the rest lengths; each segment is turned from the previous one by about `bend`.
VectorXd placed(Random& random, const Strand& strand, double bend);

// The same positions; each particle except the root is moved by about `size`, m.
VectorXd disturbed(Random& random, VectorXd x, double size);

// The maximum over the segments, NaN if one value is NaN: largest_error of | |x_i+1 - x_i| - l0 | / l0, and
// largest_rate of the velocity that stretches a segment.
double largest_error(const Strand& strand, const VectorXd& x);
double largest_rate(const Strand& strand, const VectorXd& x, const VectorXd& v);

// sqrt(sum m |dx|^2) of all particles but the root, the size of a correction.
double moved(const Strand& strand, const VectorXd& from, const VectorXd& to);

// The rounding error of a length relative to a rest length: coordinates, their differences and the norm
// round.
double rounding(const VectorXd& x, double length);

}  // namespace grader::h5

// STAFF ONLY. A student's corrections, requested through the pipe, and properties that all of them must have.
// The order of sweeps is free and methods differ, so values are compared with the reference's only where all
// methods must agree:
//
//   - small errors: a correction is W J^T lambda with J at some intermediate state. If errors are of size e,
//     all these states differ by O(e), and so do corrections, relative to their size;
//   - velocities: the correction W J^T lambda that makes J v = 0 is unique.
#pragma once

#include <Eigen/Core>
#include <string>

#include "grader/judge/cases/random.h"
#include "grader/judge/cases/trial.h"
#include "hair/length_correction.h"
#include "hair/strand.h"

namespace grader::h5 {

// Inputs of H5's hidden cases: strands, their states, and the size of their errors.

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

using hair::CorrectionReport;

inline constexpr int kRelax = 0, kCorrect = 1;
inline constexpr int kMostSweeps = 200000;  // more than any case here needs

struct Corrected {
  VectorXd result;  // x or v
  CorrectionReport report;
  VectorXd before;  // the values that went in, x or v
};

// The name of the function of kRelax or kCorrect, for feedback.
std::string name_of(int function);

Corrected correct(Trial& trial, int function, const Strand& strand, const VectorXd& x, double tolerance,
                  int most);
Corrected correct_velocities(Trial& trial, const Strand& strand, const VectorXd& x, const VectorXd& v,
                             double tolerance, int most = kMostSweeps);

VectorXd reference_lengths(const Strand& strand, VectorXd x);

// The motion of all particles and the expected one. They agree within `part` of the larger one.
Compared motions(const Corrected& corrected, const VectorXd& expected, double part);

// `slack` is the factor by which the tolerance may be exceeded.
void expect_lengths(Trial& trial, int function, const Strand& strand, double tolerance,
                    const Corrected& corrected, double slack = 1);

// This check is coarse: with any order of impulses along the segments, their sum is about the necessary
// motion, and even code that ignores the masses moves only a few times as much. A wrong place is far beyond
// that.
void expect_near(Trial& trial, int function, const Strand& strand, const VectorXd& x, const VectorXd& after);

// Compares with the reference's correction, up to the effect of the tolerance: if each segment keeps a rate
// r of the tolerance's size, that is sqrt(r' (J W J')^-1 r) in the norm of `moved`.
void expect_velocities(Trial& trial, const Strand& strand, const VectorXd& x, const VectorXd& v,
                       double tolerance);

}  // namespace grader::h5

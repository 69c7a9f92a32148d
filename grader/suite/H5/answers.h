// STAFF ONLY. A student's corrections, asked across the pipe, and what holds for all of them. Sweeps may go in
// any order and methods differ, so that values are compared with the reference's only where all must agree:
//
//   - small errors: a correction is W J^T lambda with J at some state on the way. Where errors are of size e,
//     all these states differ by O(e), and so do corrections, relative to their size;
//   - velocities: what makes J v = 0 and is W J^T lambda is one and the same for all.
#pragma once

#include <string>

#include "grader/suite/H5/strands.h"
#include "grader/suite/trial.h"
#include "hair/length_correction.h"

namespace grader::h5 {

using hair::CorrectionReport;

inline constexpr int kRelax = 0, kCorrect = 1, kVelocities = 2;  // as in serve_H5.cpp
inline constexpr int kMostSweeps = 200000;                       // more than any case here needs

struct Corrected {
  VectorXd result;  // x or v
  CorrectionReport report;
};

// kRelax's or kCorrect's, for feedback.
std::string name_of(int function);

Corrected correct(Trial& trial, int function, const Strand& strand, const VectorXd& x, double tolerance,
                  int most);
Corrected correct_velocities(Trial& trial, const Strand& strand, const VectorXd& x, const VectorXd& v,
                             double tolerance);

VectorXd reference_lengths(const Strand& strand, VectorXd x);

void expect_lengths(Trial& trial, int function, const Strand& strand, double tolerance,
                    const Corrected& corrected);

// Coarse: whatever the order of impulses along the segments, they add up to about what has to be moved, and
// even those that know no masses move a few times as much. What is put elsewhere is far beyond.
void expect_near(Trial& trial, int function, const Strand& strand, const VectorXd& x, const VectorXd& after);

// With `values`, beside the reference's: corrections differ by what the tolerance leaves, r of size tolerance
// in each segment, which is sqrt(r' (J W J')^-1 r) in the norm of `moved`.
void expect_velocities(Trial& trial, const Strand& strand, const VectorXd& x, const VectorXd& v,
                       double tolerance, bool values);

}  // namespace grader::h5

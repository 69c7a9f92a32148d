// The strands that the checks of H5 correct, measures of their errors, and H5's three functions with one
// signature.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "derivative.h"
#include "hair/length_correction.h"
#include "ordinary.h"

namespace checks {

inline hair::Strand strand_of(int count) {
  Scatter source(count);
  return ordinary_strand(source, count);
}

// A bent strand with its rest lengths, whose particles are then moved by up to `size`, but for the root.
inline Eigen::VectorXd bent(const hair::Strand& strand, double size, double bend = 0.5) {
  Scatter source(strand.count());
  Eigen::VectorXd x = ordinary_positions(source, strand, 1, 1, bend);
  x.tail(x.size() - 3) += size * scattered_vector(3 * strand.segments(), strand.count());
  return x;
}

inline double largest_error(const hair::Strand& strand, const Eigen::VectorXd& x) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double l = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    largest = std::max(largest, std::abs(l / strand.rest_length[i] - 1));
  }
  return largest;
}

// The signature that the three functions get here: `x` is the vector that is corrected.
using Correction = hair::CorrectionReport (*)(const hair::Strand&, double tolerance, int most,
                                              Eigen::VectorXd& x);

inline hair::CorrectionReport relax(const hair::Strand& strand, double tolerance, int most,
                                    Eigen::VectorXd& x) {
  return relax_lengths(strand, tolerance, most, x);
}

inline hair::CorrectionReport correct(const hair::Strand& strand, double tolerance, int most,
                                      Eigen::VectorXd& x) {
  Eigen::MatrixXd scratch = Eigen::MatrixXd::Constant(x.size(), hair::kCorrectionScratch, 1e3);
  return correct_lengths(strand, tolerance, most, x, scratch);
}

// The largest rate at which a segment is stretched, m/s, in a strand whose lengths are right.
inline double largest_rate(const hair::Strand& strand, const Eigen::VectorXd& v) {
  const Eigen::VectorXd x = bent(strand, 0);
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Eigen::Vector3d u = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).normalized();
    largest = std::max(largest, std::abs(u.dot(v.segment<3>(3 * i + 3) - v.segment<3>(3 * i))));
  }
  return largest;
}

inline hair::CorrectionReport stop_at(const Eigen::VectorXd& x, const hair::Strand& strand, double tolerance,
                                      int most, Eigen::VectorXd& v) {
  Eigen::MatrixXd scratch = Eigen::MatrixXd::Constant(v.size(), hair::kCorrectionScratch, 1e3);
  return correct_velocities(strand, x, tolerance, most, v, scratch);
}

inline hair::CorrectionReport stop(const hair::Strand& strand, double tolerance, int most,
                                   Eigen::VectorXd& v) {
  return stop_at(bent(strand, 0), strand, tolerance, most, v);
}

}  // namespace checks

// STAFF ONLY. Hairs and forces for the tests of steps: H4, H5, H6.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "hair/mass_spring/strand_forces.h"
#include "hair/predictor_corrector.h"
#include "hair/strand/make_strand.h"
#include "hair/strand/measures.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/solve_implicit.h"
#include "solver/test_numbers.h"

namespace reference_tests {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A strand, its root pinned, under its springs and gravity. `strand` must outlive it.
struct Hair {
  Hair(const hair::Strand& of, hair::GeometricTerm term, double gravity = kGravity)
      : strand(of), particles{of.mass, std::vector<char>(of.count(), 0)} {
    particles.pinned[0] = 1;
    force.emplace<hair::StretchForce>(strand, term);
    force.emplace<particles::Gravity>(strand.mass, gravity * Vector3d(0, 0, -1));
    scratch.resize(3 * strand.count(), hair::kPredictorCorrectorScratch);
  }

  // Puts the hair at rest along `direction`, with its rest lengths.
  void place(const Vector3d& direction) {
    state = {VectorXd::Zero(3 * strand.count()), VectorXd::Zero(3 * strand.count())};
    for (int i = 0; i < strand.segments(); ++i)
      state.x.segment<3>(3 * i + 3) = state.x.segment<3>(3 * i) + strand.rest_length[i] * direction;
  }

  particles::SolveReport implicit_step(double h, double tolerance = particles::kSolveTolerance) {
    return particles::implicit_euler(force, particles, h, tolerance, state, scratch);
  }
  hair::StepReport corrected_step(double h, double tolerance = particles::kSolveTolerance) {
    return hair::predictor_corrector(force, particles, strand, h, tolerance, state, scratch);
  }

  const hair::Strand& strand;
  particles::Particles particles;
  particles::ForceSum force;
  particles::State state;
  MatrixXd scratch;
};

// 30 cm of human hair in 30 segments.
inline hair::Strand human_hair() {
  return hair::uniform_strand({}, 30, 0.3);
}

inline Vector3d segment(const VectorXd& x, int i) {
  return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
}

// The largest velocity that stretches a segment, m/s.
inline double largest_rate(const hair::Strand& strand, const VectorXd& x, const VectorXd& v) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i)
    largest = std::max(largest, std::abs(segment(x, i).normalized().dot(segment(v, i))));
  return largest;
}

}  // namespace reference_tests

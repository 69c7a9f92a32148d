// STAFF ONLY. Forms (form.h) that several exercises share: strands, particles, states, reports.
#pragma once

#include <algorithm>

#include "grader/calls/form.h"
#include "hair/length_correction.h"
#include "hair/strand.h"
#include "particles/implicit_euler.h"
#include "particles/state.h"

namespace grader::inline calls {

template <>
struct Form<hair::Strand> {
  using T = hair::Strand;
  static constexpr auto fields =
      std::tuple(&T::mass, &T::rest_length, &T::stretch_rigidity, &T::bend_rigidity, &T::skip_rigidity,
                 &T::clamped, &T::root_tangent);
  static void check(const T& strand) {
    if (strand.mass.size() == 0) throw MalformedMessage("a strand without particles");
    if (strand.rest_length.size() != strand.mass.size() - 1)
      throw MalformedMessage("a strand whose segments are not one fewer than its particles");
  }
};

template <>
struct Form<particles::Particles> {
  using T = particles::Particles;
  static constexpr auto fields = std::tuple(&T::mass, &T::pinned);
  static void check(T& particles) {
    if (static_cast<Eigen::Index>(particles.pinned.size()) != particles.mass.size())
      throw MalformedMessage("particles of which some have no mass, or are neither pinned nor free");
    for (char& pinned : particles.pinned) pinned = pinned != 0 ? 1 : 0;
  }
};

template <>
struct Form<particles::State> {
  static constexpr auto fields = std::tuple(&particles::State::x, &particles::State::v);
};

// Bounds steps that an untrusted sender counts, so that sums of a few such numbers are still ints. Negative
// ones stay wrong.
inline void bound_steps(int& steps) {
  steps = std::clamp(steps, -1, 1 << 28);
}

template <>
struct Form<particles::SolveReport> {
  using T = particles::SolveReport;
  static constexpr auto fields =
      std::tuple(&T::steps, &T::residual, &T::rhs, &T::converged, &T::preconditioned);
  static void check(T& report) { bound_steps(report.steps); }
};

template <>
struct Form<hair::CorrectionReport> {
  using T = hair::CorrectionReport;
  static constexpr auto fields = std::tuple(&T::iterations, &T::error, &T::converged);
  static void check(T& report) { bound_steps(report.iterations); }
};

}  // namespace grader::calls

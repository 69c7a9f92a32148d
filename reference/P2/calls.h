// STAFF ONLY. The calls of P2; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "particles/constraint_forces.h"

namespace grader {

template <>
struct Form<particles::Rod> {
  using T = particles::Rod;
  static constexpr auto fields = std::tuple(&T::i, &T::j, &T::length);
};

template <>
struct Form<particles::Wire> {
  using T = particles::Wire;
  static constexpr auto fields = std::tuple(&T::i, &T::centre, &T::normal, &T::radius);
};

template <>
struct Form<particles::Constraints> {
  using T = particles::Constraints;
  static constexpr auto fields = std::tuple(&T::rods, &T::wires, &T::stiffness, &T::damping);
};

template <>
struct Form<particles::ConstraintReport> {
  using T = particles::ConstraintReport;
  static constexpr auto fields = std::tuple(&T::steps, &T::residual);
  static void check(T& report) { bound_steps(report.steps); }
};

}  // namespace grader

namespace grader::p2 {

using particles::Constraints;

// Throws MalformedMessage if a constraint holds a particle that is not there.
inline void expect_particles(const Constraints& constraints, Eigen::Index size) {
  const auto expect = [n = size / 3](int i) {
    if (i < 0 || i >= n)
      throw MalformedMessage("a constraint of particle " + std::to_string(i) + " of " + std::to_string(n));
  };
  for (const particles::Rod& rod : constraints.rods) expect(rod.i), expect(rod.j);
  for (const particles::Wire& wire : constraints.wires) expect(wire.i);
}

// A vector has three numbers for each particle, or one for each row of J.
inline void expect_rows(const Constraints& constraints, Eigen::Index size) {
  if (size != constraints.rows())
    throw MalformedMessage(std::to_string(size) + " numbers for " + std::to_string(constraints.rows()) +
                           " rows of constraints");
}

struct Values {
  static void check(const Constraints& constraints, const auto& x, const auto& C) {
    expect_particles(constraints, x.size());
    expect_rows(constraints, C.size());
  }
};

struct Rates {
  static void check(const Constraints& constraints, const auto& x, const auto& v, const auto& rates) {
    SameSizes::check(x, v);
    Values::check(constraints, x, rates);
  }
};

struct Forces {
  static void check(const Constraints& constraints, const auto& x, const auto& lambda, const auto& f) {
    SameSizes::check(x, f);
    Values::check(constraints, x, lambda);
  }
};

struct Solves {
  static void check(const Constraints& constraints, const particles::Particles& particles,
                    const particles::State& state) {
    SameSizes::check(state, particles);
    expect_particles(constraints, state.x.size());
  }
  static void check(const Constraints& constraints, const particles::Particles& particles,
                    const particles::State& state, const auto& f, const auto& lambda) {
    check(constraints, particles, state);
    SameSizes::check(state, f);
    expect_rows(constraints, lambda.size());
  }
  static std::array<Eigen::Index, 2> shape(const Constraints& constraints, const particles::Particles&,
                                           const particles::State&) {
    return {constraints.rows(), constraints.rows()};
  }
};

struct Calls : CallList<Call<particles::constraint_values, Contract{}, Values>,
                        Call<particles::constraint_rates, Contract{}, Rates>,
                        Call<particles::add_constraint_forces, Contract{}, Forces>,
                        Call<particles::constraint_matrix, Contract{}, Solves>,
                        Call<particles::solve_constraints, Contract{}, Solves>> {
  static constexpr const char* id = "P2";
};

}  // namespace grader::p2

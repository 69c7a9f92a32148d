// STAFF ONLY. Serves P2, by function. After the function's number come constraints, particles, x and v; then
//   0 constraint_values      junk                 -> C
//   1 constraint_rates       junk                 -> rates
//   2 add_constraint_forces  lambda, f            -> f
//   3 constraint_matrix      multiplier, junk, changes -> product, multiplier; product again
//   4 solve_constraints      f, junk              -> steps, residual, lambda
// `junk` is what the output's buffer holds before the call.
#include <algorithm>

#include "grader/wire/constraints_message.h"
#include "grader/wire/particles_message.h"
#include "grader/worker/session.h"

namespace {

using grader::GuardedBuffer;
using grader::Session;

// A vector of the request's, in guarded memory.
struct Vector {
  Vector(Session& session, Eigen::Index size)
      : buffer(session.request.get_doubles(static_cast<std::size_t>(size))), view(buffer.data(), size) {}

  GuardedBuffer buffer;
  Eigen::Map<Eigen::VectorXd> view;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) void serve(Session& session) {
  using namespace particles;
  const int function = session.request.get<int>();
  const Constraints constraints = grader::get_constraints(session.request);
  const Particles particles = grader::get_particles(session.request);
  const int rows = constraints.rows(), size = 3 * particles.count();
  const Vector x(session, size), v(session, size);
  const State state{x.view, v.view};

  if (function == 0) {
    Vector C(session, rows);
    constraint_values(constraints, x.view, C.view);
    session.reply.put(C.buffer.values());
  } else if (function == 1) {
    Vector rates(session, rows);
    constraint_rates(constraints, x.view, v.view, rates.view);
    session.reply.put(rates.buffer.values());
  } else if (function == 2) {
    const Vector lambda(session, rows);
    Vector f(session, size);
    add_constraint_forces(constraints, x.view, lambda.view, f.view);
    session.reply.put(f.buffer.values());
  } else if (function == 3) {
    Vector multiplier(session, rows);
    const std::vector<double> junk = session.request.get_doubles(static_cast<std::size_t>(rows));
    GuardedBuffer first(junk), second(junk);
    // What the matrix refers to; with `changes` it gets its values when the matrix is there.
    Constraints held = constraints;
    Particles weights = particles;
    State now = state;
    if (session.request.get<std::uint8_t>() != 0) {
      std::reverse(held.rods.begin(), held.rods.end());
      weights.mass *= 2;
      now.x *= 1.5;
    }
    const std::unique_ptr<implicitMatrix> matrix = constraint_matrix(held, weights, now);
    held = constraints;
    weights = particles;
    now = state;
    matrix->matVecMult(multiplier.view.data(), first.data());
    matrix->matVecMult(multiplier.view.data(), second.data());
    session.reply.put(first.values()).put(multiplier.buffer.values()).put(second.values());
  } else {
    const Vector f(session, size);
    Vector lambda(session, rows);
    const ConstraintReport report = solve_constraints(constraints, particles, state, f.view, lambda.view);
    session.reply.put(report.steps).put(report.residual).put(lambda.buffer.values());
  }
}

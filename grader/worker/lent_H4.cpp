// STAFF ONLY. H4, lent by the suite. Of a force that the suite serves it gets the name alone; about another one it asks.
#include "particles/implicit_euler.h"

#include "grader/wire/particles_message.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"
#include "grader/worker/lent_objects.h"

namespace particles {
namespace {

grader::MessageWriter arguments(int function, const Force& force, const Particles& particles,
                                const State& state) {
  const Eigen::Index size = Eigen::Index{3} * particles.count();
  if (state.x.size() != size || state.v.size() != size)
    throw std::invalid_argument("a state of " + std::to_string(state.x.size()) + " and " +
                                std::to_string(state.v.size()) + " numbers; expected " +
                                std::to_string(size));
  grader::MessageWriter call;
  call.put(function).put(static_cast<std::uint8_t>(&force == lent_session->served_force));
  grader::put(call, particles);
  grader::put(call, state);
  return call;
}

class LentMatrix : public implicitMatrix {
 public:
  LentMatrix(const Force& force, const Particles& particles, const State& state, double a, double b)
      : force_(force), particles_(particles), state_(state), a_(a), b_(b) {}

  void matVecMult(double x[], double b[]) override {
    const grader::Session::Uncounted ours(*lent_session);
    const std::size_t size = static_cast<std::size_t>(state_.x.size());
    grader::MessageWriter call = arguments(grader::kLentImplicitProduct, force_, particles_, state_);
    call.put(a_).put(b_).put(std::span<const double>(x, size));
    const std::vector<double> product =
        lent_session->call(call, grader::callback_of(force_)).get_doubles(size);
    std::copy(product.begin(), product.end(), b);
  }

 private:
  const Force& force_;
  const Particles& particles_;
  const State& state_;
  double a_, b_;
};

}  // namespace

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  const grader::Session::Uncounted ours(*lent_session);
  return std::make_unique<LentMatrix>(force, particles, state, a, b);
}

SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state, double a,
                           double b, double tolerance, Output dv, Scratch scratch) {
  const grader::Session::Uncounted ours(*lent_session);
  grader::MessageWriter call = arguments(grader::kLentSolveImplicit, force, particles, state);
  call.put(a).put(b).put(tolerance);
  grader::MessageReader result = lent_session->call(call, grader::callback_of(force));
  dv = grader::get_vector(result, state.x.size());
  grader::spoil(scratch, kImplicitScratch);
  return grader::get_solve_report(result);
}

SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch) {
  const grader::Session::Uncounted ours(*lent_session);
  grader::MessageWriter call = arguments(grader::kLentImplicitEuler, force, particles, state);
  call.put(h).put(tolerance);
  grader::MessageReader result = lent_session->call(call, grader::callback_of(force));
  state = grader::get_state(result, particles.count());
  grader::spoil(scratch, kImplicitScratch);
  return grader::get_solve_report(result);
}

}  // namespace particles

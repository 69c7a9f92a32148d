// STAFF ONLY. Serves P1. Request: method (the contract's order, from 0), n, h, steps, columns of scratch, the
// number that scratch holds, x, v. Reply: x and v after each step, 6n numbers a step.
#include "grader/worker/served_dynamics.h"
#include "particles/explicit_integrators.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  using namespace particles;
  const int method = session.request.get<int>(), n = session.request.get<int>();
  const double h = session.request.get<double>();
  const int steps = session.request.get<int>(), columns = session.request.get<int>();
  const double junk = session.request.get<double>();
  const std::size_t size = 3 * static_cast<std::size_t>(n);
  grader::GuardedBuffer x_buffer(session.request.get_doubles(size)),
      v_buffer(session.request.get_doubles(size)), scratch_buffer(std::vector<double>(size * columns, junk));
  Eigen::Map<Eigen::VectorXd> x(x_buffer.data(), 3 * n), v(v_buffer.data(), 3 * n);
  Eigen::Map<Eigen::MatrixXd> scratch(scratch_buffer.data(), 3 * n, columns);

  constexpr void (*kMethods[])(Dynamics&, double, Output, Output, Scratch) = {forward_euler, symplectic_euler,
                                                                              midpoint, runge_kutta_4};
  grader::ServedDynamics dynamics(session, n);
  std::vector<double> states;
  states.reserve(2 * size * steps);
  for (int step = 0; step < steps; ++step) {
    session.counted([&] { kMethods[method](dynamics, h, x, v, scratch); });
    for (const grader::GuardedBuffer* buffer : {&x_buffer, &v_buffer})
      states.insert(states.end(), buffer->values().begin(), buffer->values().end());
  }
  session.reply.put(std::span<const double>(states));
}

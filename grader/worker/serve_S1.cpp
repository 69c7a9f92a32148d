// STAFF ONLY. Serves S1. Request: n, epsilon, steps, calls, x, b. Reply: the return value, steps and x of the last call.
// All calls share b: what one does to it, the next one meets.
#include "grader/worker/session.h"
#include "solver/linearSolver.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const int n = session.request.get<int>();
  const double epsilon = session.request.get<double>();
  const int most_steps = session.request.get<int>(), calls = session.request.get<int>();
  const std::vector<double> first_x = session.request.get_doubles(n);
  grader::GuardedBuffer b(session.request.get_doubles(n));

  grader::ServedMatrix A(session, 0, n, n);
  for (int call = 1; call <= calls; ++call) {
    grader::GuardedBuffer x(first_x);
    int steps = most_steps;
    const double value = ConjGrad(n, &A, x.data(), b.data(), epsilon, &steps);
    if (call == calls) session.reply.put(value).put(steps).put(x.values());
  }
}

// STAFF ONLY. Serves S1. Request: n, epsilon, steps, x, b. Reply: the return value, steps, x, b, products
// whose input and output overlapped.
#include "grader/worker/session.h"
#include "solver/linearSolver.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const int n = session.request.get<int>();
  const double epsilon = session.request.get<double>();
  int steps = session.request.get<int>();
  grader::GuardedBuffer x(session.request.get_doubles(n)), b(session.request.get_doubles(n));

  grader::ServedMatrix A(session, 0, n, n);
  const double value = ConjGrad(n, &A, x.data(), b.data(), epsilon, &steps);
  session.reply.put(value).put(steps).put(x.values()).put(b.values()).put(A.mistakes());
}

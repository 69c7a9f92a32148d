// STAFF ONLY. Serves S2, by function:
//   0 dense_matrix            rows, cols, a, x, junk                  -> result; result again, of the same x
//   1 normal_matrix           rows, cols, x, junk                     -> result; result again, of the same x
//   2 solve_normal_equations  rows, cols, epsilon, steps, calls, x, b -> return value, steps, x of the last call
// All calls share b: what one does to it, the next one meets. `junk` is what the result's buffer holds before the product.
#include <algorithm>
#include <limits>

#include "grader/worker/session.h"
#include "solver/normal_equations.h"

namespace {

using grader::GuardedBuffer;
using grader::ServedMatrix;
using grader::Session;

// The product twice, into buffers that hold junk: an operator that adds to what it finds, or that changes its
// input, shows. Only normal_matrix promises to allocate nothing in it.
void multiply_twice(Session& session, implicitMatrix& matrix, bool promised) {
  GuardedBuffer x(session.request.get_doubles());
  const std::vector<double> junk = session.request.get_doubles();
  GuardedBuffer first(junk), second(junk);
  for (GuardedBuffer* product : {&first, &second}) {
    const auto multiply = [&] { matrix.matVecMult(x.data(), product->data()); };
    promised ? session.counted(multiply) : multiply();
  }
  session.reply.put(first.values()).put(second.values());
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void serve(Session& session) {
  const int function = session.request.get<int>();
  const int rows = session.request.get<int>(), cols = session.request.get<int>();
  ServedMatrix A(session, 0, rows, cols), A_transposed(session, 1, cols, rows);

  if (function == 0) {
    GuardedBuffer table(session.request.get_doubles());
    const std::unique_ptr<implicitMatrix> matrix = dense_matrix(rows, cols, table.data());
    // The table is the caller's, who may change it.
    std::fill(table.data(), table.data() + table.values().size(), std::numeric_limits<double>::quiet_NaN());
    multiply_twice(session, *matrix, false);
  } else if (function == 1) {
    multiply_twice(session, *normal_matrix(rows, cols, &A, &A_transposed), true);
  } else {
    const double epsilon = session.request.get<double>();
    const int most_steps = session.request.get<int>(), calls = session.request.get<int>();
    const std::vector<double> first_x = session.request.get_doubles(cols);
    GuardedBuffer b(session.request.get_doubles(rows));
    for (int call = 1; call <= calls; ++call) {
      GuardedBuffer x(first_x);
      int steps = most_steps;
      const double value =
          solve_normal_equations(rows, cols, &A, &A_transposed, x.data(), b.data(), epsilon, &steps);
      if (call == calls) session.reply.put(value).put(steps).put(x.values());
    }
  }
}

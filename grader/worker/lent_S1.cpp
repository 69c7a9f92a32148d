// STAFF ONLY. S1, lent by the suite: it solves, and asks for each product with the caller's matrix.
#include <algorithm>
#include <functional>

#include "grader/worker/lent_objects.h"
#include "solver/linearSolver.h"

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  const grader::Session::Uncounted ours(*lent_session);
  if (n < 0) throw std::invalid_argument("ConjGrad of " + std::to_string(n) + " unknowns");
  const std::size_t size = static_cast<std::size_t>(n);
  grader::MessageWriter call;
  call.put(grader::kLentConjGrad).put(n).put(epsilon).put(*steps).put(std::span<const double>(b, size));
  grader::MessageReader result =
      lent_session->call(call, [A](int, std::vector<double>& in, std::vector<double>& out) {
        out.resize(in.size());
        A->matVecMult(in.data(), out.data());
      });
  const double value = result.get<double>();
  *steps = result.get<int>();
  const std::vector<double> solution = result.get_doubles(size);
  std::copy(solution.begin(), solution.end(), x);
  // No contract allows x and b to overlap: what comes out is NaN.
  const std::less<const double*> before;
  if (before(x, b + n) && before(b, x + n)) std::fill(x, x + n, std::numeric_limits<double>::quiet_NaN());
  return value;
}

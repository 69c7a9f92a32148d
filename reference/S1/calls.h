// STAFF ONLY. The calls of S1; see grader/calls/call.h. ConjGrad has plain arrays: here they have their
// lengths. b goes there and back, too: the contract does not let it change.
#pragma once

#include "grader/calls/call.h"
#include "solver/linearSolver.h"

namespace grader::s1 {

inline double conj_grad(Operator A, particles::Output x, particles::Output b, double epsilon, int& steps) {
  return ConjGrad(A.cols, A.matrix, x.data(), b.data(), epsilon, &steps);
}

struct SquareSystem {
  static void check(const Operator& A, const auto& x, const auto& b, double, int) {
    if (A.rows != A.cols || x.size() != A.rows || b.size() != A.rows)
      throw MalformedMessage("a system of " + std::to_string(A.rows) + " unknowns with vectors of " +
                             std::to_string(x.size()) + " and " + std::to_string(b.size()) + " numbers");
  }
};

struct Calls : CallList<Call<conj_grad, Contract{}, SquareSystem>> {
  static constexpr const char* id = "S1";
};

}  // namespace grader::s1

// STAFF ONLY. The calls of S2; see grader/calls/call.h. The contract has plain arrays: here they have their
// lengths. b goes there and back, too: the contract does not let it change.
#pragma once

#include "grader/calls/call.h"
#include "solver/normal_equations.h"

namespace grader::s2 {

inline std::unique_ptr<implicitMatrix> dense(int rows, int cols, particles::Input entries) {
  return dense_matrix(rows, cols, entries.data());
}

inline std::unique_ptr<implicitMatrix> normal(Operator A, Operator A_transposed) {
  return normal_matrix(A.rows, A.cols, A.matrix, A_transposed.matrix);
}

// (A'A)'(A'A): an operator of operators, both of which work while the outer one multiplies.
inline std::unique_ptr<implicitMatrix> normal_of_normal(Operator A, Operator A_transposed) {
  struct Nested : implicitMatrix {
    std::unique_ptr<implicitMatrix> inner, outer;
    void matVecMult(double x[], double b[]) override { outer->matVecMult(x, b); }
  };
  auto nested = std::make_unique<Nested>();
  nested->inner = normal(A, A_transposed);
  nested->outer = normal_matrix(A.cols, A.cols, nested->inner.get(), nested->inner.get());
  return nested;
}

inline double solve_normal(Operator A, Operator A_transposed, particles::Output x, particles::Output b,
                           double epsilon, int& steps) {
  return solve_normal_equations(A.rows, A.cols, A.matrix, A_transposed.matrix, x.data(), b.data(), epsilon,
                                &steps);
}

struct Table {
  static void check(int rows, int cols, const auto& entries) {
    if (rows < 0 || cols < 0 || entries.size() != Eigen::Index{rows} * cols)
      throw MalformedMessage("a table of " + std::to_string(rows) + " rows and " + std::to_string(cols) +
                             " columns with " + std::to_string(entries.size()) + " entries");
  }
  static std::array<Eigen::Index, 2> shape(int rows, int cols, const auto& /*entries*/) {
    return {rows, cols};
  }
};

struct Transposed {
  static constexpr int kMost = 1 << 20;  // no message holds a vector of more numbers

  static void check(const Operator& A, const Operator& A_transposed) {
    if (A.rows != A_transposed.cols || A.cols != A_transposed.rows || std::max(A.rows, A.cols) > kMost)
      throw MalformedMessage("a matrix of " + std::to_string(A.rows) + " rows and " + std::to_string(A.cols) +
                             " columns with a transposed one of " + std::to_string(A_transposed.rows) +
                             " and " + std::to_string(A_transposed.cols));
  }
  static std::array<Eigen::Index, 2> shape(const Operator& A, const Operator& /*A_transposed*/) {
    return {A.cols, A.cols};
  }
};

struct NormalSystem {
  static void check(const Operator& A, const Operator& A_transposed, const auto& x, const auto& b, double,
                    int) {
    Transposed::check(A, A_transposed);
    if (x.size() != A.cols || b.size() != A.rows)
      throw MalformedMessage("a system of " + std::to_string(A.rows) + " equations for " +
                             std::to_string(A.cols) + " unknowns with vectors of " +
                             std::to_string(x.size()) + " and " + std::to_string(b.size()) + " numbers");
  }
};

struct Calls
    : CallList<Call<dense, Contract{}, Table>, Call<normal, Contract{}, Transposed>,
               Call<solve_normal, Contract{}, NormalSystem>, Call<normal_of_normal, Contract{}, Transposed>> {
  static constexpr const char* id = "S2";
};

}  // namespace grader::s2

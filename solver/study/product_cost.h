// The lecture's "Why implicitMatrix?": the cost of a product with a strand's matrix, by a formula and by the
// table of its entries.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/linearSolver.h"
#include "solver/study/cpu_time.h"

namespace solver::study {

// M + h^2 K of a strand, like strand_implicit_euler in solver/matrices.h: three numbers for each particle.
struct StrandFormula {
  std::vector<double> mass;           // kg
  std::vector<double> stretch, bend;  // h^2 k of the spring above each particle, along z and across, kg

  // b = A x for n = 3 mass.size(). Number is any type with addition and multiplication by a number.
  template <class Number>
  void multiply(int n, const Number* x, Number* b) const {
    const int particles = n / 3;
    for (int p = 0; p < particles; ++p)
      for (int c = 0; c < 3; ++c) {
        const std::vector<double>& spring = c == 2 ? stretch : bend;
        const int i = 3 * p + c;
        const bool last = p + 1 == particles;
        b[i] = (mass[p] + spring[p] + (last ? 0 : spring[p + 1])) * x[i];
        if (p > 0) b[i] = b[i] - spring[p] * x[i - 3];
        if (!last) b[i] = b[i] - spring[p + 1] * x[i + 3];
      }
  }
};

// All entries, by rows.
struct Table {
  std::vector<double> entries;  // n x n

  template <class Number>
  void multiply(int n, const Number* x, Number* b) const {
    for (int i = 0; i < n; ++i) {
      const double* row = &entries[static_cast<std::size_t>(i) * n];
      Number sum = row[0] * x[0];
      for (int j = 1; j < n; ++j) sum = sum + row[j] * x[j];
      b[i] = sum;
    }
  }
};

StrandFormula strand_formula(int particles, double step);
Table table_of(const StrandFormula& formula, int n);

struct ProductCost {
  int n = 0;
  struct Way {
    long multiplications = 0;  // counted during a product
    std::size_t bytes = 0;     // memory of the matrix
    double seconds = 0;        // s, one product
  } formula, table;
};

// n = 3 particles.
ProductCost product_cost(int particles, const Timing& timing);

}  // namespace solver::study

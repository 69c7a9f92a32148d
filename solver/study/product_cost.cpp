#include "solver/study/product_cost.h"

#include "solver/study/systems.h"

namespace solver::study {

namespace {

// A number that notes each multiplication.
struct Counted {
  double value = 0;
  long* count = nullptr;
};

Counted operator*(double a, const Counted& b) {
  ++*b.count;
  return {a * b.value, b.count};
}
Counted operator+(const Counted& a, const Counted& b) {
  return {a.value + b.value, a.count};
}
Counted operator-(const Counted& a, const Counted& b) {
  return {a.value - b.value, a.count};
}

template <class Matrix>
ProductCost::Way cost_of(const Matrix& matrix, int n, std::size_t bytes, const Timing& timing) {
  ProductCost::Way way;
  way.bytes = bytes;
  std::vector<Counted> counted(n, {1, &way.multiplications}), ignored(n);
  matrix.multiply(n, counted.data(), ignored.data());
  const Vector x = scattered(n, 5);
  Vector b(n);
  way.seconds = median_seconds(timing, [&] { matrix.multiply(n, x.data(), b.data()); });
  return way;
}

}  // namespace

StrandFormula strand_formula(int particles, double step) {
  const StrandNumbers numbers = strand_numbers(particles);
  return {Vector(particles, numbers.mass), Vector(particles, step * step * numbers.stretch),
          Vector(particles, step * step * numbers.bend)};
}

Table table_of(const StrandFormula& formula, int n) {
  Table table = {Vector(static_cast<std::size_t>(n) * n)};
  Vector unit(n), column(n);
  for (int j = 0; j < n; ++j) {
    unit[j] = 1;
    formula.multiply(n, unit.data(), column.data());
    unit[j] = 0;
    for (int i = 0; i < n; ++i) table.entries[static_cast<std::size_t>(i) * n + j] = column[i];
  }
  return table;
}

ProductCost product_cost(int particles, const Timing& timing) {
  const int n = 3 * particles;
  const StrandFormula formula = strand_formula(particles, 1.0 / 240);
  ProductCost cost;
  cost.n = n;
  cost.formula = cost_of(formula, n, 3 * formula.mass.size() * sizeof(double), timing);
  const Table table = table_of(formula, n);
  cost.table = cost_of(table, n, table.entries.size() * sizeof(double), timing);
  return cost;
}

}  // namespace solver::study

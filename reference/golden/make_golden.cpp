// STAFF ONLY. Makes the golden data of the public checks: make_golden DIR.
//
// For each case DIR holds the matrix NAME.mtx, the right-hand side NAME.b.mtx and the reference's solution
// NAME.x.mtx, and a line of DIR/S1.txt or DIR/S2.txt: its name, epsilon, the number of steps and the smallest
// eigenvalue of A or of A'A. The hidden suite draws its inputs from seeds of its own; these are fixed.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/linearSolver.h"
#include "solver/matrices.h"
#include "solver/matrix_market.h"
#include "solver/normal_equations.h"

namespace {

using Vector = std::vector<double>;
using solver::SparseMatrix;

Vector random_vector(int n, double scale, std::mt19937& random) {
  Vector values(n);
  for (double& value : values) value = scale * (random() / 2147483648.0 - 1);
  return values;
}

// The Laplacian of a random graph plus a ground spring at each node: symmetric, positive definite.
SparseMatrix random_springs(int n, std::mt19937& random) {
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < n; ++i) {
    entries.push_back({i, i, 0.5});
    for (int k = 0; k < 3; ++k) {
      const int j = static_cast<int>(random() % n);
      if (i == j) continue;
      const double stiffness = 0.1 + random() / 4294967296.0;
      entries.insert(entries.end(),
                     {{i, i, stiffness}, {j, j, stiffness}, {i, j, -stiffness}, {j, i, -stiffness}});
    }
  }
  return SparseMatrix(n, n, entries);
}

// Diffusion with wind from one side: not symmetric. Its symmetric part is at least 0.5.
SparseMatrix wind(int n) {
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < n; ++i) {
    if (i > 0) entries.push_back({i, i - 1, -1.4});
    entries.push_back({i, i, 2.5});
    if (i + 1 < n) entries.push_back({i, i + 1, -0.6});
  }
  return SparseMatrix(n, n, entries);
}

// [D C'; C 0]: the system of springs D with constraints C, symmetric and indefinite.
SparseMatrix constrained(int springs, int constraints, std::mt19937& random) {
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < springs; ++i) entries.push_back({i, i, 1 + random() / 4294967296.0});
  for (int i = 0; i < constraints; ++i)
    for (int j : {2 * i, 2 * i + 1}) {
      entries.push_back({springs + i, j, 1});
      entries.push_back({j, springs + i, 1});
    }
  return SparseMatrix(springs + constraints, springs + constraints, entries);
}

SparseMatrix random_table(int rows, int cols, std::mt19937& random) {
  const Vector values = random_vector(rows * cols, 1, random);
  std::vector<SparseMatrix::Entry> entries;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < cols; ++j) entries.push_back({i, j, values[i * cols + j]});
  return SparseMatrix(rows, cols, entries);
}

// The smallest singular value of A, which is the smallest eigenvalue of a symmetric, positive definite
// matrix, less one percent, far more than rounding.
double smallest_singular_value(const SparseMatrix& A) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(A.rows(), A.cols());
  for (const SparseMatrix::Entry& e : A.entries()) dense(e.row, e.col) = e.value;
  return 0.99 * Eigen::JacobiSVD<Eigen::MatrixXd>(dense).singularValues().minCoeff();
}

struct Answer {
  Vector x;
  double returned;
  int steps;
};
using Solve = std::function<Answer(SparseMatrix& A, Vector b, double epsilon, int most_steps)>;

Answer conjugate_gradients(SparseMatrix& A, Vector b, double epsilon, int most_steps) {
  Answer answer{Vector(b.size()), 0, most_steps};
  answer.returned =
      ConjGrad(static_cast<int>(b.size()), &A, answer.x.data(), b.data(), epsilon, &answer.steps);
  return answer;
}

Answer normal_equations(SparseMatrix& A, Vector b, double epsilon, int most_steps) {
  SparseMatrix transposed = A.transposed();
  Answer answer{Vector(A.cols()), 0, most_steps};
  answer.returned = solve_normal_equations(A.rows(), A.cols(), &A, &transposed, answer.x.data(), b.data(),
                                           epsilon, &answer.steps);
  return answer;
}

struct System {
  SparseMatrix A;
  Vector b;
};

// The same system with its unknowns and equations in another order, which rounds differently.
System reordered(const System& system, std::mt19937& random) {
  const int most = std::max(system.A.rows(), system.A.cols());
  std::vector<int> order(most);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  auto places_below = [&](int n) {  // a permutation of 0 .. n - 1
    std::vector<int> places;
    std::copy_if(order.begin(), order.end(), std::back_inserter(places),
                 [n](int place) { return place < n; });
    return places;
  };
  const std::vector<int> row_places = places_below(system.A.rows()),
                         col_places = places_below(system.A.cols());
  std::vector<SparseMatrix::Entry> entries = system.A.entries();
  for (SparseMatrix::Entry& e : entries) e = {row_places[e.row], col_places[e.col], e.value};
  Vector b(system.b.size());
  for (std::size_t i = 0; i < b.size(); ++i) b[row_places[i]] = system.b[i];
  return {SparseMatrix(system.A.rows(), system.A.cols(), entries), b};
}

// An epsilon that the squared residual crosses in one leap, from at least twice to at most half of it, in
// each order of the sums. So rounding can't change the number of steps.
double clear_epsilon(const System& system, const Solve& solve) {
  std::mt19937 random(1);
  std::vector<System> orders = {system};
  for (int k = 0; k < 20; ++k) orders.push_back(reordered(system, random));
  const double first = solve(orders[0].A, orders[0].b, 0, -1).returned;
  double smallest_before = first;
  for (int steps = 1; steps <= 60; ++steps) {
    double smallest = smallest_before, largest = 0;
    for (System& s : orders) {
      const double squared = solve(s.A, s.b, 0, steps).returned;
      smallest = std::min(smallest, squared);
      largest = std::max(largest, squared);
    }
    if (largest < 1e-6 * first && largest < smallest_before / 4) return std::sqrt(smallest_before * largest);
    smallest_before = smallest;
  }
  throw std::runtime_error(
      "no step cuts the squared residual to a quarter in every order; choose another matrix");
}

template <typename Write>
void write_file(const std::filesystem::path& path, Write write) {
  std::ofstream out(path);
  write(out);
  if (!out.flush()) throw std::runtime_error("can't write " + path.string());
}

// Returns the case's line in the list.
std::string write_case(const std::filesystem::path& dir, const std::string& name, System system,
                       double smallest, const Solve& solve) try {
  const double epsilon = clear_epsilon(system, solve);
  const Answer answer = solve(system.A, system.b, epsilon, 0);
  write_file(dir / (name + ".mtx"), [&](std::ostream& out) { solver::write_matrix_market(out, system.A); });
  write_file(dir / (name + ".b.mtx"), [&](std::ostream& out) { solver::write_vector(out, system.b); });
  write_file(dir / (name + ".x.mtx"), [&](std::ostream& out) { solver::write_vector(out, answer.x); });
  char line[200];
  std::snprintf(line, sizeof line, "%s %.17g %d %.6g\n", name.c_str(), epsilon, answer.steps, smallest);
  return line;
} catch (const std::exception& problem) {
  throw std::runtime_error(name + ": " + problem.what());
}

void write_list(const std::filesystem::path& path, const std::string& smallest, const std::string& list) {
  write_file(path, [&](std::ostream& out) {
    out << "# case, epsilon, steps, smallest eigenvalue of " << smallest << "\n" << list;
  });
}

void make_golden(const std::filesystem::path& dir) {
  std::filesystem::create_directories(dir);
  std::mt19937 random(20071);
  std::string list;

  // The system is scaled to ||b|| = ||b - Ab|| = 1.
  auto positive = [&](const std::string& name, SparseMatrix A) {
    Vector b = random_vector(A.rows(), 1, random);
    const double length = std::sqrt(std::inner_product(b.begin(), b.end(), b.begin(), 0.0));
    for (double& value : b) value /= length;
    A = scaled(A, solver::even_scale(A, b));
    list += write_case(dir, name, {A, b}, smallest_singular_value(A), conjugate_gradients);
  };
  positive("poisson", solver::poisson_2d(7));
  positive("strand", solver::strand_implicit_euler(Vector(20, 2e-8), 40, 0.05, 1e-4));
  positive("springs", random_springs(80, random));
  write_list(dir / "S1.txt", "A", list);

  list.clear();
  auto any = [&](const std::string& name, const SparseMatrix& A) {
    list += write_case(dir, name, {A, random_vector(A.rows(), 1, random)},
                       std::pow(smallest_singular_value(A), 2), normal_equations);
  };
  any("wind", wind(40));
  any("constrained", constrained(24, 10, random));
  any("least_squares", random_table(50, 8, random));
  write_list(dir / "S2.txt", "A'A", list);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: make_golden DIR");
  make_golden(argv[1]);
} catch (const std::exception& problem) {
  std::fprintf(stderr, "make_golden: %s\n", problem.what());
  return 2;
}

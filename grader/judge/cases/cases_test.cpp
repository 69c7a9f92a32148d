// STAFF ONLY. Tests that the suite's bounds hold for right solutions, in whatever order they add, and that
// one wrong constant costs one category: the energy's factor excuses that of the force, and the force's that
// of the product.
#include "grader/judge/cases/linear_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "grader/judge/cases/strand_force.h"

namespace grader::inline judge {
namespace {

// Holds the same matrix with its unknowns in another order: place i holds the unknown order[i].
class Reordered : public implicitMatrix {
 public:
  Reordered(std::shared_ptr<implicitMatrix> inside, std::vector<int> order)
      : inside_(std::move(inside)), order_(std::move(order)) {}

  void matVecMult(double x[], double b[]) override {
    std::vector<double> in(order_.size()), out(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) in[order_[i]] = x[i];
    inside_->matVecMult(in.data(), out.data());
    for (std::size_t i = 0; i < order_.size(); ++i) b[i] = out[order_[i]];
  }

 private:
  std::shared_ptr<implicitMatrix> inside_;
  std::vector<int> order_;
};

LinearSystem reordered(const LinearSystem& system, const std::vector<int>& order) {
  LinearSystem result = system;
  result.A = std::make_shared<Reordered>(system.A, order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.b[i] = system.b[order[i]];
    result.solution[i] = system.solution[order[i]];
  }
  return result;
}

// Counts the steps of the textbook's algorithm in long double; only the products are in double.
int steps_in_long_double(const LinearSystem& system, double epsilon) {
  const std::size_t n = system.b.size();
  std::vector<double> in = system.b, out(n);
  system.A->matVecMult(in.data(), out.data());
  std::vector<long double> x(in.begin(), in.end()), r(n), d;
  for (std::size_t i = 0; i < n; ++i) r[i] = static_cast<long double>(system.b[i]) - out[i];
  d = r;
  long double rr = std::inner_product(r.begin(), r.end(), r.begin(), 0.0L);
  int steps = 0;
  for (; rr > epsilon && steps < 1000; ++steps) {
    std::copy(d.begin(), d.end(), in.begin());
    system.A->matVecMult(in.data(), out.data());
    const long double alpha = rr / std::inner_product(d.begin(), d.end(), out.begin(), 0.0L), before = rr;
    for (std::size_t i = 0; i < n; ++i) r[i] -= alpha * out[i];
    rr = std::inner_product(r.begin(), r.end(), r.begin(), 0.0L);
    for (std::size_t i = 0; i < n; ++i) d[i] = r[i] + rr / before * d[i];
  }
  return steps;
}

std::vector<LinearSystem> well_conditioned(Random& random) {
  std::vector<LinearSystem> systems;
  for (double condition : {10.0, 100.0, 1000.0})
    systems.push_back(
        spectral_system("spectrum", solver::log_spaced(random.integer(20, 80), 1, condition), random));
  const int n = random.integer(20, 60);
  systems.push_back(sparse_system("tridiagonal", solver::tridiagonal(n, 2, -0.8), random.normals(n), 0.4));
  systems.push_back(sparse_system("string", solver::tridiagonal(n, 2, -1), random.normals(n),
                                  4 * std::pow(std::sin(std::numbers::pi / (2 * (n + 1))), 2)));
  const int grid = random.integer(5, 12);
  systems.push_back(sparse_system("grid", solver::poisson_2d(grid), random.normals(grid * grid),
                                  8 * std::pow(std::sin(std::numbers::pi / (2 * (grid + 1))), 2)));
  return systems;
}

TEST(ToleranceAfter, IsMetByTheSameStepInEveryOrderOfSummation) {
  for (int seed = 0; seed < 20; ++seed) {
    Random random(std::to_string(seed), "order");
    for (const LinearSystem& system : well_conditioned(random)) {
      std::vector<int> backwards(system.n()), shuffled;
      std::iota(backwards.rbegin(), backwards.rend(), 0);
      shuffled = backwards;
      for (int i = system.n() - 1; i > 0; --i) std::swap(shuffled[i], shuffled[random.integer(0, i)]);
      for (int least : {1, 3, 6, 10}) {
        const auto [epsilon, steps] = tolerance_after(system, least);
        SCOPED_TRACE(system.name + ", n = " + std::to_string(system.n()) + ", " + std::to_string(steps) +
                     " steps");
        EXPECT_GE(steps, least);
        EXPECT_EQ(reference_solution(system, epsilon, 0).steps, steps);
        EXPECT_EQ(reference_solution(reordered(system, backwards), epsilon, 0).steps, steps);
        EXPECT_EQ(reference_solution(reordered(system, shuffled), epsilon, 0).steps, steps);
        EXPECT_EQ(steps_in_long_double(system, epsilon), steps);
      }
    }
  }
}

TEST(ToleranceAfter, IsFoundWhereEigenvaluesHappenToBeOne) {
  for (double gap : {1e-6, 1e-12, 0.0}) {
    const LinearSystem system =
        sparse_system("diagonal", solver::diagonal({7, 7 * (1 + gap), 7}), {1, -2, 0.5}, 7);
    const auto [epsilon, steps] = tolerance_after(system, 3);
    EXPECT_GE(steps, 1) << gap;
    EXPECT_EQ(reference_solution(system, epsilon, 0).steps, steps) << gap;
  }
}

TEST(Even, HasResidualsThatBeginAtTheLengthOfB) {
  Random random("0", "even");
  for (const LinearSystem& any : well_conditioned(random)) {
    const LinearSystem system = even(any);
    EXPECT_NEAR(norm(system.b), 1, 1e-14) << any.name;
    EXPECT_NEAR(true_residual(system, system.b), 1, 1e-12) << any.name;
    EXPECT_NEAR(true_residual(system, system.solution), 0, 1e-12) << any.name;
  }
}

TEST(PlannedSystem, HasTheResidualsThatWereChosen) {
  Random random("0", "planned");
  for (const std::vector<double>& ratios :
       {std::vector<double>(14, 1), std::vector<double>{1, 0.4, 1.8, 1.3, 0.2}}) {
    const LinearSystem system = planned_system("planned", ratios, random);
    double expected = true_residual(system, system.b);
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      expected *= ratios[k];
      const double reached = std::sqrt(reference_solution(system, 0, static_cast<int>(k) + 1).value);
      EXPECT_NEAR(reached / expected, 1, 1e-9) << k;
    }
    EXPECT_LT(std::sqrt(reference_solution(system, 0, system.n()).value), 1e-9 * expected);
  }
}

// Divides the distance between the return value's root and the true ||b - Ax|| by `drift`.
double part_of_drift(const LinearSystem& system, double epsilon, int steps) {
  const Solution solution = reference_solution(system, epsilon, steps);
  return std::abs(std::sqrt(solution.value) - true_residual(system, solution.x)) /
         drift(system, solution.x, solution.value);
}

TEST(Drift, BoundsTheReferenceOnEverySystemAtEveryLength) {
  double most = 0;
  for (int seed = 0; seed < 10; ++seed) {
    Random random(std::to_string(seed), "drift");
    std::vector<LinearSystem> systems = well_conditioned(random);
    for (double condition : {1e4, 1e8, 1e12})
      systems.push_back(spectral_system("ill-conditioned", solver::log_spaced(60, 1 / condition, 1), random));
    for (int size : {4, 8, 12})
      systems.push_back(sparse_system("Hilbert", solver::hilbert(size), random.normals(size), 0));
    std::vector<double> masses(20);
    for (double& mass : masses) mass = random.log_uniform(1e-8, 1);
    systems.push_back(sparse_system("strand", solver::strand_implicit_euler(masses, 2000, 0.005, 1.0 / 60),
                                    random.normals(60, 0.1), 1e-8));
    for (const LinearSystem& system : systems)
      for (int steps : {1, 10, 63, 64, 200, 1000}) {
        const double part = part_of_drift(system, 0, steps);
        EXPECT_LE(part, 1) << system.name << ", " << steps << " steps";
        most = std::max(most, part);
      }
  }
  // A bound that is much too wide would hold, too.
  EXPECT_GT(most, 1e-5);
}

// This is E = x . x / 2. The strand's rigidities are the factors by which the student's answers are off.
const StrandForce kForce{
    .energy = [](Trial&,
                 const Posed& posed) { return posed.strand.stretch_rigidity * posed.x.squaredNorm() / 2; },
    .ask_force = [](Trial&, const Posed& posed, const VectorXd& before) -> VectorXd {
      return before - posed.strand.bend_rigidity * posed.x;
    },
    .reference_energy = [](const Posed& posed) { return posed.x.squaredNorm() / 2; },
    .reference_force = [](const Posed& posed) -> VectorXd { return -posed.x; },
    .products = {{[](Trial&, const Posed& posed, const VectorXd& dx, const VectorXd& before) -> VectorXd {
                    return before - posed.strand.skip_rigidity * dx;
                  },
                  [](const Posed&, const VectorXd& dx) -> VectorXd { return -dx; }}},
    .energy_rounding = [](const Posed&) { return 1e-12; },
    .force_rounding = [](const Posed&) { return 1e-12; },
    .product_rounding = [](const Posed&, const VectorXd&) { return 1e-12; },
    .rigidity = &Strand::stretch_rigidity};

TEST(StrandForce, OneWrongConstantCostsOneCategory) {
  const struct {
    double energy, force, product;
    const char* fails;
  } rows[] = {{1, 1, 1, ""},
              {2, 2, 2, "energy "},
              {2, 1, 1, "energy "},
              {1, 2, 2, "force "},
              {1, 1, 2, "product "},
              {2, 4, 4, "energy force "},
              {2, 2, 4, "energy product "},
              {0, 2, 2, "energy force "},
              {1, -1, -1, "force product "}};
  for (const auto& [energy, force, product, fails] : rows) {
    Posed posed;
    posed.strand.stretch_rigidity = energy;
    posed.strand.bend_rigidity = force;
    posed.strand.skip_rigidity = product;
    posed.x = VectorXd::LinSpaced(6, 1, 2);
    Student nobody{WorkerSetup{}};
    Trial trial(nobody, Random("seed", "a case"));
    std::string failed;
    const auto ask = [&](const char* what, const auto& question) {
      try {
        question();
      } catch (const CaseFailed&) {
        failed += what;
      }
    };
    ask("energy ", [&] { expect_energy(trial, kForce, posed); });
    ask("force ", [&] { expect_force(trial, kForce, posed); });
    ask("product ",
        [&] { expect_product(trial, kForce, kForce.products[0], posed, VectorXd::LinSpaced(6, 2, -1)); });
    EXPECT_EQ(failed, fails) << energy << ", " << force << ", " << product;
  }
}

}  // namespace
}  // namespace grader::judge

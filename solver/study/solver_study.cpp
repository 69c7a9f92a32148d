#include "solver/study/solver_study.h"

#include <cmath>

#include "solver/study/banded_cholesky.h"
#include "solver/study/history.h"
#include "solver/study/systems.h"

namespace solver::study {

namespace {

constexpr int kMostIterations = 30000, kMostIterationsQuick = 4000;
constexpr int kSegments = 30;

// Eigen's method behind ConjGrad's interface.
double eigen_as_conj_grad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  double squared_b = 0;
  for (int i = 0; i < n; ++i) squared_b += b[i] * b[i];
  eigen_conj_grad(n, A, x, b, std::sqrt(epsilon / squared_b), steps);
  return std::nan("");  // it does not report this
}

// The result of a solver for the tolerance kNeededTolerance and a matrix of norm `norm`.
struct Solved {
  int steps;      // as it reports
  long products;  // counted
  double norm, solution, right_side, residual;
};

// The solver's steps, if its residual is true and its products fit this number: one each, and sometimes a
// second. Rounding may keep the recurrence's residual away from the true one, by linearSolver.h's bound for a
// residual that is never replaced: products' errors of n u, for reflections.
std::optional<int> believed(const Solved& solved, int n, int most) {
  const double steps = solved.steps;
  const double rounding =
      (steps + 1) * (10 + 2.0 * n) * kRounding * solved.norm * (2 * solved.solution + solved.right_side);
  const bool is_true = steps >= 0 && steps <= most && solved.products <= 2 * (steps + 1) &&
                       solved.residual <= kNeededTolerance * solved.right_side + rounding;
  return is_true ? std::optional(solved.steps) : std::nullopt;
}

double norm_of(const Vector& x) {
  return std::sqrt(squared_norm(x));
}

class Study {
 public:
  Study(const Functions& functions, const Settings& settings, const Watch& watch,
        const std::function<void(const std::string&)>& say)
      : functions_(functions), watch_(watch), say_(say) {
    study_.quick = settings.quick;
    study_.most_iterations = settings.quick ? kMostIterationsQuick : kMostIterations;
    timing_ = settings.quick ? Timing{2e-5, 3} : Timing{1e-4, 7};
  }

  SolverStudy run() {
    const double start = timing::cpu_seconds();
    histories();
    needed();
    if (functions_.normal_equations) digits();
    study_.cpu_seconds = timing::cpu_seconds() - start;
    return std::move(study_);
  }

 private:
  // Does nothing if they are missing, or a stub.
  void with_normal_equations(const std::function<void()>& does) {
    if (!functions_.normal_equations || study_.not_written) return;
    try {
      does();
    } catch (const NotImplemented& stub) {
      study_.not_written = stub;
    }
  }

  void histories() {
    say_("condition numbers");
    for (const double condition : {1e1, 1e2, 1e3, 1e4, 1e6}) {
      if (study_.quick && condition > 1e4) continue;
      study_.conditions.push_back(compared(spread_system(kUnknowns, condition)));
    }
    say_("a strand");
    for (const double step : {1e-5, 1e-4, 1e-3, 1e-2}) {
      const SparseMatrix matrix = strand_matrix(kSegments, step);
      study_.strands.push_back(compared(strand_system(kSegments, step), &matrix));
    }
  }

  // `banded` is the system's matrix, if it has a band.
  Compared compared(const System& system, const SparseMatrix* banded = nullptr) const {
    const ConjGradFunction eigen = eigen_as_conj_grad;
    Compared on = {history_of(functions_.conj_grad, "ConjGrad", system, study_.most_iterations, watch_),
                   history_of(eigen, "Eigen's CG", system, study_.most_iterations, watch_),
                   {}};
    std::optional<BandedCholesky> factored;
    Vector x;
    std::vector<TimedCall> calls;
    if (banded) {
      factored.emplace(*banded);
      on.direct = cholesky(system, *factored);
      calls = {{[&] { factored->factor(); }, &on.direct->factor_seconds},
               {[&] {
                  x = system.right_side;  // copying counts, because the right-hand side is still needed
                  factored->solve(x.data());
                },
                &on.direct->solve_seconds}};
    }
    time_in_turn(system, {{&functions_.conj_grad, &on.conj_grad}, {&eigen, &on.eigen}}, std::move(calls),
                 timing_, watch_);
    return on;
  }

  static DirectSolve cholesky(const System& system, const BandedCholesky& factored) {
    Vector x = system.right_side;
    factored.solve(x.data());
    DirectSolve direct = {system.name, "banded Cholesky"};
    direct.error = energy_norm(*system.matrix, difference(x, system.solution)) /
                   energy_norm(*system.matrix, difference(system.right_side, system.solution));
    direct.squared_residual = squared_norm(difference(system.right_side, product(*system.matrix, x))) /
                              squared_norm(system.right_side);
    return direct;
  }

  void needed() {
    say_("iterations against condition number");
    for (const double condition : log_spaced(study_.quick ? 5 : 13, 1e1, study_.quick ? 1e5 : 1e7)) {
      watch_.look();
      const System system = spread_system(kUnknowns, condition);
      IterationsNeeded one;
      one.condition = condition;
      one.conj_grad = iterations_needed(functions_.conj_grad, system, study_.most_iterations);
      one.eigen = iterations_needed(eigen_as_conj_grad, system, study_.most_iterations);
      one.clustered =
          iterations_needed(functions_.conj_grad, clustered_system(kUnknowns, condition, kNeededClusters),
                            study_.most_iterations);
      with_normal_equations([&] {
        one.normal_equations =
            normal_iterations_needed(functions_.normal_equations, system, study_.most_iterations);
      });
      one.bound = needed_at_most(condition);
      study_.needed.push_back(one);
    }
  }

  void digits() {
    if (study_.not_written) return;
    say_("digits lost by the normal equations");
    for (const double condition : log_spaced(study_.quick ? 8 : 15, 1, 1e14)) {
      watch_.look();
      study_.digits.push_back(digits_lost(functions_.normal_equations, condition, 3, study_.most_iterations));
    }
  }

  const Functions& functions_;
  const Watch& watch_;
  const std::function<void(const std::string&)>& say_;
  Timing timing_;
  SolverStudy study_;
};

}  // namespace

double needed_at_most(double condition) {
  const double root = std::sqrt(condition);
  return std::ceil(root / 2 * std::log(2 * root / kNeededTolerance));
}

std::optional<int> iterations_needed(const ConjGradFunction& solve, const System& system, int most) {
  CountingMatrix A(*system.matrix);
  Vector x(system.solution.size()), b = system.right_side;
  const double right_side = norm_of(b);
  int steps = most;
  solve(system.n(), &A, x.data(), b.data(), std::pow(kNeededTolerance * right_side, 2), &steps);
  const Vector residual = difference(system.right_side, product(*system.matrix, x));
  return believed({steps, A.count(), system.largest, norm_of(system.solution), right_side, norm_of(residual)},
                  system.n(), most);
}

std::optional<int> normal_iterations_needed(const NormalEquationsFunction& solve, const System& system,
                                            int most) {
  CountingMatrix A(*system.matrix);
  Vector x(system.solution.size()), b = system.right_side;
  const double right_side = norm_of(product(*system.matrix, b));  // A is its own transpose
  int steps = most;
  solve(system.n(), system.n(), &A, system.matrix.get(), x.data(), b.data(),
        std::pow(kNeededTolerance * right_side, 2), &steps);
  const Vector residual = product(*system.matrix, difference(system.right_side, product(*system.matrix, x)));
  return believed({steps, A.count(), system.largest * system.largest, norm_of(system.solution), right_side,
                   norm_of(residual)},
                  system.n(), most);
}

std::optional<SolverStudy> study_solvers(const Functions& functions, const Settings& settings,
                                         const std::atomic<bool>& interrupted,
                                         const std::function<void(const std::string&)>& say) {
  const Watch watch = {&interrupted};
  try {
    return Study(functions, settings, watch, say).run();
  } catch (const Interrupted&) {
    return std::nullopt;
  }
}

}  // namespace solver::study

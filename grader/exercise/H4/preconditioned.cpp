// STAFF ONLY. H4: hidden cases of solves with a preconditioner.
#include <algorithm>
#include <cmath>

#include "grader/exercise/H4/answers.h"
#include "grader/exercise/H4/cases.h"
#include "grader/exercise/H4/stiff_hair.h"

namespace grader::h4 {
namespace {

// `converged` is what the header says: where the preconditioner is far from the matrix, which takes more than one solve, and where what
// rounding leaves is more than the right-hand side, because hair falls, in a unit of 2^-20 m.
void expect_true_verdicts(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 8; ++repeat)
    for (double tolerance : {1e-6, 1e-10, 0.0}) {
      const double h = 1.0 / random.integer(60, 240);
      const Cloud hair =
          repeat % 2 == 0
              ? hair_without_band(random, h)
              : in_other_units(hanging_hair_with_band(random, 12, random.log_uniform(1e4, 1e6), h), 1,
                               0x1p-20);
      const int size = 3 * hair.count();
      const ImplicitSystem system = implicit_system(hair, h, h);
      const Solution solution = solve(trial, hair, h, h, tolerance);
      const double length = solution.dv.norm(), residual = system.residual(solution.dv),
                   reported = solution.report.residual;
      trial.expect_at_most(std::abs(reported - residual),
                           8 * (size + 8) * kUnit * (system.norm * length + system.rhs.norm()),
                           "the error of the report's residual");
      Eigen::MatrixXd scratch(size, particles::kPreconditionerScratch);
      const particles::Preconditioner known(*hair.force, hair.particles, hair.state, h, h, scratch);
      const auto met = [&](double r) {
        return r <= tolerance * system.rhs.norm() || known.rounding_allows(r, length, system.rhs.norm());
      };
      if (met(1.01 * reported) || tolerance > 0)
        trial.expect(solution.report.converged,
                     "a solve that meets its tolerance is reported as not converged, or could meet it");
      if (!met(0.99 * reported))
        trial.expect(!solution.report.converged,
                     "a solve that does not meet its tolerance is reported as converged");
      const int outside = solution.dfdv - solution.report.steps - solution.report.steps / 64;
      trial.expect(
          outside <= 2 * particles::kMostSolves || solution.dfdv <= size + 4,
          "it takes more solves than it may, or the report's steps are not all that ConjGrad took",
          std::to_string(solution.report.steps) + ", " + std::to_string(solution.dfdv) + " products");
    }
}

// A solve breaks down where the matrix is not positive definite, and may lead farther away: what does is not added to dv. The
// residual is that of the dv that is returned, up to rounding, which is 1e-12 of these numbers.
void expect_no_farther(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 4; ++repeat) {
    const double h = 1.0 / random.integer(60, 240);
    const Cloud hair = compressed_without_band(random, h);
    const ImplicitSystem system = implicit_system(hair, h, h);
    const Solution solution = solve(trial, hair, h, h);
    trial.expect(solution.dv.allFinite(), "dv is not finite, where the matrix is not positive definite");
    trial.expect_at_most(std::abs(solution.report.residual - system.residual(solution.dv)),
                         1e-9 * (system.norm * solution.dv.norm() + system.rhs.norm()),
                         "the error of the report's residual where the matrix is not positive definite");
  }
}

// Springs of which the band knows nothing, from h^2 k/m = 1 to 1e6 between any two particles: ConjGrad uses all its
// iterations, each solve makes the residual smaller, and none reaches a tolerance of 0.
void expect_all_iterations(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 3; ++repeat) {
    const double h = 1.0 / random.integer(60, 240);
    const Cloud hair = tangle_without_band(random, 33, h);
    const int size = 3 * hair.count(), most = std::max(100, size);
    const Solution solution = solve(trial, hair, h, h, 0);
    const int steps = solution.report.steps;
    // Who writes the matrix out takes 3n products, however many solves there are.
    const int outside = solution.dfdv - steps - steps / 64;
    trial.expect(steps % most == 0 && steps <= particles::kMostSolves * most &&
                     (outside <= 2 * particles::kMostSolves || solution.dfdv <= size + 4),
                 "a solve that does not meet its tolerance takes other iterations than it may",
                 std::to_string(steps) + ", " + std::to_string(most) + " each time; products " +
                     std::to_string(solution.dfdv));
  }
}

// With masses in units of 2^40 or 2^-40 kg, and lengths in units of 2^20 or 2^-20 m, all numbers are those of before times powers
// of two. So rounding and steps stay the same, unless something is compared with a number that has a unit.
void expect_same_in_other_units(Trial& trial) {
  Random& random = trial.random;
  const double h = 1.0 / random.integer(60, 240);
  for (Cloud hair : {stiff_hair(random, 12, h, 2), hair_without_band(random, h)}) {
    // A pinned particle's row has a 1 in it, whatever the unit, and Preconditioner::norm looks at that row, too.
    hair.particles.pinned.assign(hair.count(), 0);
    for (double tolerance : {kTolerance, 0.0}) {
      // In units of 1, for sums of forces have another order there.
      const Solution known = solve(trial, in_other_units(hair, 1, 1), h, h, tolerance);
      for (double mass : {0x1p-40, 0x1p40})
        for (double length : {0x1p-20, 0x1p20}) {
          const Solution solution = solve(trial, in_other_units(hair, mass, length), h, h, tolerance);
          trial.expect(solution.dv.isApprox(length * known.dv, 1e-6) &&
                           solution.report.steps == known.report.steps &&
                           solution.report.converged == known.report.converged,
                       "other units of mass or length make another solve",
                       std::to_string(solution.report.steps) + " steps, " +
                           std::to_string(known.report.steps) + " before");
        }
    }
  }
}

}  // namespace

// Beside the products for the right-hand side, each solve takes one more than its iterations, and one for its residual.
// The first residual of a preconditioned solve is what rounding leaves, 1e-8 or so for such hair, and an iteration
// multiplies it by as much: two of them reach 1e-10. What the band does not know of, a spring, adds three eigenvalues,
// and an iteration for each of them. Who writes the matrix out takes 3n products.
void preconditioned(Trial& trial) {
  Random& random = trial.random;
  for (int n : {12, 40})
    for (int far : {0, 1, 4}) {
      const double h = 1.0 / random.integer(60, 240), a = random.uniform(0.4, 1) * h;
      const Cloud hair = stiff_hair(random, n, h, far);
      const ImplicitSystem system = implicit_system(hair, a, h);
      const Solution solution = solve(trial, hair, a, h);
      const double size = system.norm * solution.dv.norm() + system.rhs.norm();
      const double residual = system.residual(solution.dv);
      trial.expect_at_most(residual, kTolerance * system.rhs.norm() + 0x1p-48 * size,
                           "the residual of the implicit step's system");
      // It is computed anew, by one product: 3n terms in each of two products, and what puts them together.
      trial.expect_at_most(std::abs(solution.report.residual - residual), 8 * (3 * n + 8) * kUnit * size,
                           "the error of the report's residual");
      trial.expect(solution.report.converged,
                   "a solve that meets its tolerance is reported as not converged");
      trial.expect(solution.bands >= 1, "the forces' band is not asked for: there is no preconditioner");
      trial.expect(solution.report.preconditioned,
                   "a solve with a preconditioner is reported as one without");
      const int steps = particles::kMostSolves * (2 + 3 * far);
      trial.expect_at_most(solution.report.steps, steps, "the number of steps with a preconditioner");
      trial.expect_at_most(solution.dfdx, std::max(1 + steps + 2 * particles::kMostSolves, 3 * n + 4),
                           "the number of products with df/dx");
      const int outside = solution.dfdv - solution.report.steps - solution.report.steps / 64;
      trial.expect(
          outside <= 2 * particles::kMostSolves || solution.dfdv <= 3 * n + 4,
          "the report's steps are not all that ConjGrad took",
          std::to_string(solution.report.steps) + ", " + std::to_string(solution.dfdv) + " products");

      const Solution moved = step(trial, hair, h);
      const ImplicitSystem whole = implicit_system(hair, h, h);
      const double allowed = 0x1p-48 * (whole.norm * moved.dv.norm() + whole.rhs.norm());
      // dv is the difference of two velocities.
      trial.expect_at_most(whole.residual(moved.dv),
                           kTolerance * whole.rhs.norm() + allowed + 4 * kUnit * whole.norm * moved.v.norm(),
                           "the residual of a step's system");
    }
  expect_true_verdicts(trial);
  expect_all_iterations(trial);
  expect_no_farther(trial);
  expect_same_in_other_units(trial);
  trial.expect(!solve(trial, random_cloud(random, "particles without a band", 3, 1, 1, 3, 0), 0.5, 0.5)
                    .report.preconditioned,
               "a solve without a preconditioner is reported as one with it");
}

}  // namespace grader::h4

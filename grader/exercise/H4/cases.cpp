// STAFF ONLY. H4: hidden cases of implicit_matrix, solve_implicit and implicit_euler.
#include "grader/exercise/H4/cases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "grader/exercise/H4/answers.h"
#include "grader/exercise/H4/stiff_hair.h"
#include "grader/suite/whole_run_points.h"
#include "particles/springs.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;

void matrix(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 2, 5, 12}) {
    const Cloud cloud = random_cloud(random, "particles of 1 kg", n, 1, 1, 3, 0);
    expect_matrix(trial, cloud, random.uniform(0.2, 0.8), random.uniform(0.2, 0.8));
  }
}

// df/dx at one velocity and not another, df/dv at one place and one velocity.
Cloud mixed_cloud(Random& random, int n) {
  Cloud cloud = random_cloud(random, "particles whose damping depends on place and speed", n, 1, 1, 3, 4);
  cloud.force = std::make_shared<MixedForce>(random, n, 3, 4);
  return cloud;
}

// At rest, with b = 1: what else there is on the right-hand side, or a factor that is missing, costs nothing here.
void damping(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 4, 9}) {
    Cloud cloud = random_cloud(random, "damped particles of 1 kg", n, 1, 1, 2, 4);
    cloud.state.v.setZero();
    const double a = random.uniform(0.2, 0.8);
    expect_matrix(trial, cloud, a, 1);
    expect_solves(trial, implicit_system(cloud, a, 1), solve(trial, cloud, a, 1).dv);
    expect_matrix(trial, mixed_cloud(random, n), a, 1);
  }
  // With much drag, a and b for each other are another matrix: a preconditioner for that one takes more steps (see `preconditioned`). What
  // takes more without drag, too, has another reason.
  const double h = 1.0 / random.integer(60, 240), a = random.uniform(0.3, 0.6) * h;
  const Solution without_drag = solve(trial, stiff_hair(random, 12, h, 0), a, h),
                 hair = solve(trial, stiff_hair(random, 12, h, 0, random.uniform(50, 100)), a, h);
  const int most = 2 * particles::kMostSolves;
  if (hair.report.preconditioned && without_drag.report.steps <= most)
    trial.expect_at_most(hair.report.steps, most,
                         "the number of steps with a preconditioner where drag is strong");
}

void pinned(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 2, 6}) {
    Cloud cloud = random_cloud(random, "pinned particles", n, 1, 1, 3, 0);
    cloud.particles.pinned[random.integer(0, n - 1)] = 1;
    if (n > 3) cloud.particles.pinned[0] = cloud.particles.pinned[n - 1] = 1;
    const double h = random.uniform(0.2, 0.8);
    expect_matrix(trial, cloud, h, random.uniform(0.2, 0.8));
    const Solution solution = step(trial, cloud, h);
    for (int i = 0; i < n; ++i) {
      if (!cloud.particles.is_pinned(i)) continue;
      const Eigen::Vector3d v = cloud.state.v.segment<3>(3 * i);
      trial.expect(solution.v.segment<3>(3 * i) == v, "a pinned particle changes its velocity");
      const Eigen::Vector3d x = cloud.state.x.segment<3>(3 * i) + h * v;
      trial.expect_at_most((solution.x.segment<3>(3 * i) - x).norm(), 4 * kUnit * (x.norm() + h * v.norm()),
                           "the error of a pinned particle's position");
    }
    expect_solves(trial, implicit_system(cloud, h, h), solution.dv);
  }
}

void masses(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 3, 8}) {
    const double unit = random.log_uniform(1e-6, 1e-3);
    Cloud cloud = random_cloud(random, "light particles, masses 1:100", n, unit, 100 * unit, 10 * unit, 0);
    cloud.state.v.setZero();
    const double a = random.uniform(0.2, 0.8);
    expect_matrix(trial, cloud, a, 1);
    expect_solves(trial, implicit_system(cloud, a, 1), solve(trial, cloud, a, 1).dv);
  }
}

void system(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 2, 5, 12, 20}) {
    const Cloud cloud = random_cloud(random, "particles of 1 kg", n, 1, 1, random.log_uniform(1, 30), 0);
    const double a = random.uniform(0.2, 0.8), b = random.uniform(0.2, 0.8);
    const ImplicitSystem system = implicit_system(cloud, a, b);
    const Solution solution = solve(trial, cloud, a, b);
    expect_solves(trial, system, solution.dv);
    trial.expect_at_most(std::abs(solution.report.rhs - system.rhs.norm()),
                         system.rounding + 1e-12 * system.rhs.norm(),
                         "the error of the report's norm of the right-hand side");
  }
  for (int n : {2, 7}) {
    const Cloud cloud = mixed_cloud(random, n);
    const double a = random.uniform(0.2, 0.8), b = random.uniform(0.2, 0.8);
    // So tight that a derivative at another state, which changes little, shows.
    expect_solves(trial, implicit_system(cloud, a, b), solve(trial, cloud, a, b).dv, kTolerance);
  }
}

void a_step(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 3, 10}) {
    const Cloud cloud = random_cloud(random, "particles of 1 kg", n, 1, 1, 3, 0);
    const double h = random.uniform(0.2, 0.8);
    const ImplicitSystem system = implicit_system(cloud, h, h);
    const Solution solution = step(trial, cloud, h);
    expect_solves(trial, system, solution.dv);
    const VectorXd x = cloud.state.x + h * solution.v;
    trial.expect_at_most((solution.x - x).norm(), 4 * kUnit * (x.norm() + h * solution.v.norm()),
                         "the difference between x and the old x + h times the new v");
  }
}

void tolerance(Trial& trial) {
  Random& random = trial.random;
  const double h = 1.0 / random.integer(60, 240);
  Cloud hair = chain(random, random.integer(20, 30), 1e-7, 1e5, h);
  hair.state.v.setZero();
  const ImplicitSystem system = implicit_system(hair, h, h);
  const Solution fine = solve(trial, hair, h, h);
  expect_solves(trial, system, fine.dv, kTolerance);
  const Solution coarse = solve(trial, hair, h, h, 1e-2);
  expect_solves(trial, system, coarse.dv, 1e-2);
  trial.expect(coarse.report.steps < fine.report.steps,
               "a tolerance of 1e-2 takes as many steps as one of 1e-10",
               std::to_string(coarse.report.steps) + " and " + std::to_string(fine.report.steps));
  for (const Solution& solution : {fine, coarse}) {
    trial.expect_at_most(std::abs(solution.report.residual - system.residual(solution.dv)),
                         system.rounding + 1e-9 * system.residual(solution.dv),
                         "the error of the report's residual");
    trial.expect(solution.report.converged, "a solve that meets its tolerance is reported as not converged");
  }

  // The squares of what is left of such forces are below the range of a float.
  const Cloud light = chain(random, 40, random.log_uniform(1e-13, 1e-12), 20, h);
  const Solution little = solve(trial, light, h, h);
  expect_solves(trial, implicit_system(light, h, h), little.dv, kTolerance);
  // No eigenvalue is below 0.7 or above 1.4 + 4 * 20: 139 steps, as in `cost`, and a third more for rounding.
  trial.expect_at_most(little.report.steps, 185, "the number of steps for a light chain");
  trial.expect(little.report.converged, "a solve that meets its tolerance is reported as not converged");

  // Nothing to solve: 0 <= tolerance 0.
  for (Cloud still : {hair, stiff_hair(random, 12, h, 0)}) {
    still.name += ", all pinned";
    still.particles.pinned.assign(still.count(), 1);
    const Solution nothing = solve(trial, still, h, h);
    trial.expect(nothing.dv.isZero(0) && nothing.report.steps == 0 && nothing.report.residual == 0,
                 "a right-hand side of 0 does not give a dv of 0 after 0 steps");
    trial.expect(nothing.report.converged, "a right-hand side of 0 is reported as not converged");
  }
}

// Where rounding leaves more than any tolerance that may be tried, a solve uses all iterations each time, and says so.
void expect_end_of_rounding(Trial& trial) {
  Random& random = trial.random;
  const double h = 1.0 / random.integer(60, 240);
  const Cloud hair = hanging_hair(random, 10, random.log_uniform(1e14, 1e15), h);
  const Solution solution = solve(trial, hair, h, h);
  const ImplicitSystem system = implicit_system(hair, h, h);
  trial.expect(!solution.report.converged,
               "a solve that does not meet its tolerance is reported as converged");
  trial.expect(solution.dv.allFinite(), "dv is not finite, where rounding allows no solution");
  // At 1e-10, 1e-8 and 1e-6.
  const int most = std::max(100, 60 * hair.count()), steps = solution.report.steps;
  // No rounding is between what ConjGrad returned last and what is reported.
  if (!trial.provided_solves().empty())
    trial.expect_at_most(std::abs(solution.report.residual - std::sqrt(trial.provided_solves().back().value)),
                         1e-12 * solution.report.residual, "the error of the report's residual");
  trial.expect(steps >= most && steps <= 3 * most,
               "a solve that does not meet its tolerance takes other iterations than it may",
               std::to_string(steps) + ", " + std::to_string(most) + " each time");
  // No tolerance may be tried above 1e-6, so ConjGrad is called once. It may break down, but not each time.
  int longest = 0;
  for (int repeat = 0; repeat < 3; ++repeat) {
    const Solution once =
        solve(trial, hanging_hair(random, 10, random.log_uniform(1e14, 1e15), h), h, h, 1e-6);
    longest = std::max(longest, once.report.converged ? 0 : once.report.steps);
  }
  trial.expect(longest == 0 || longest == most,
               "a solve that does not meet its tolerance takes other iterations than it may",
               std::to_string(longest) + " of " + std::to_string(most));
  const int products = solution.dfdv;
  // Where 1e-6 can be met, but not 1e-10, that is not what was asked for.
  const Solution loose = solve(trial, hanging_hair(random, 10, random.log_uniform(1e8, 1e9), h), h, h);
  trial.expect(!loose.report.converged || loose.report.residual <= 1.01 * kTolerance * loose.report.rhs,
               "a solve that does not meet its tolerance is reported as converged");
  trial.expect(products <= 3 * hair.count() + 4 || std::abs(products - steps - steps / 64) <= 6,
               "the report's steps are not all that ConjGrad took",
               std::to_string(steps) + ", " + std::to_string(products) + " products");
}

void cost(Trial& trial) {
  Random& random = trial.random;
  const double h = 1.0 / random.integer(60, 240);
  for (int n : {4, 16, 64, 256}) {
    // Masses of 0.7 to 1.4 and h^2 k = 2, in units of 1e-7 kg: no eigenvalue is below 0.7 or above 1.4 + 4 * 2,
    // whatever n, so that the condition number is at most 13.5.
    const Cloud cloud = chain(random, n, 1e-7, 2, h);
    const Solution solution = step(trial, cloud, h);
    trial.expect(solution.forces == 1, "a step does not take one evaluation of the force",
                 std::to_string(solution.forces));
    // One with each for each product that ConjGrad takes; or the matrix is written out first, by 3n of each.
    const int products = 1 + solution.report.steps + solution.report.steps / 64,
              most = std::max(products, 3 * n);
    const int least = std::min(products, 3 * n - 3);
    const auto between = [](int low, int value, int high) { return low <= value && value <= high; };
    trial.expect(between(least, solution.dfdv, most) && between(least + 1, solution.dfdx, most + 1),
                 "a step takes other products with df/dx and df/dv than ConjGrad's steps ask for",
                 std::to_string(solution.dfdx) + " and " + std::to_string(solution.dfdv) + ", ConjGrad's " +
                     std::to_string(products));
    // sqrt(13.5) = 3.7: the residual falls to 2 * 3.7 ((3.7 - 1) / (3.7 + 1))^k of the first in k steps (Greenbaum,
    // "Iterative Methods", 1997, section 3.1), to 1e-10 in 45; a third more for rounding.
    trial.expect_at_most(solution.report.steps, 60, "the number of steps for a chain that is not stiff");
  }
}

// A particle of mass m on a spring, turning around its pinned end.
Cloud turning(double stiffness_over_mass, particles::Products products) {
  Cloud cloud;
  cloud.name = "turning on a stiff spring";
  cloud.particles = {Eigen::Vector2d(0.7, 0.7), {1, 0}};
  cloud.state = {VectorXd::Zero(6), VectorXd::Zero(6)};
  cloud.state.x[3] = 0.3;
  cloud.state.v[4] = 0.3 * 2 * std::numbers::pi;
  cloud.force = std::make_shared<particles::DampedSprings>(
      std::vector<particles::Spring>{{0, 1, 0.7 * stiffness_over_mass, 0.3}}, products);
  return cloud;
}

// Both numbers are those of the assignment's table: any right implementation has them, to the tolerance.
void revolution(Trial& trial) {
  Cloud cloud = turning(1e8, particles::Products::definite);
  const double h = 1.0 / 60, before = 0.3 * 0.3 * 2 * std::numbers::pi;
  for (int i = 0; i < 60; ++i) {
    const Solution solution = step(trial, cloud, h);
    trial.expect(solution.x.allFinite() && solution.v.allFinite(), "a step is not finite");
    cloud.state = {solution.x, solution.v};
  }
  const Eigen::Vector3d x = cloud.state.x.tail<3>(), v = cloud.state.v.tail<3>();
  trial.expect_at_most(std::abs(x.cross(v)[2] / before - 0.0049), 1e-4,
                       "the error of the angular momentum that is left after a revolution");

  // A linear oscillator: backward Euler's amplitude per step is 1 / sqrt(1 + h^2 w^2).
  const double w = trial.random.uniform(5, 300);
  Cloud oscillator = turning(w * w, particles::Products::exact);
  oscillator.name = "an oscillator";
  oscillator.state.x[3] = 0.3 + 0.01;
  oscillator.state.v.setZero();
  const auto amplitude = [w](const VectorXd& position, const VectorXd& velocity) {
    return std::hypot(position[3] - 0.3, velocity[3] / w);
  };
  for (int i = 0; i < 3; ++i) {
    const Solution solution = step(trial, oscillator, h);
    const double ratio =
        amplitude(solution.x, solution.v) / amplitude(oscillator.state.x, oscillator.state.v);
    trial.expect_at_most(std::abs(ratio * std::sqrt(1 + h * h * w * w) - 1), 1e-3,
                         "the error of the amplitude that an oscillator has after a step");
    oscillator.state = {solution.x, solution.v};
  }
}

void unsolvable(Trial& trial) {
  Random& random = trial.random;
  expect_solves(trial, implicit_system(turning(100, particles::Products::exact), 0.1, 0.1),
                solve(trial, turning(100, particles::Products::exact), 0.1, 0.1).dv);
  // A spring under compression, h^2 k/m (l0/l - 1) > 1: the matrix has two negative eigenvalues.
  Cloud compressed = turning(1e4, particles::Products::exact);
  compressed.state.x[3] = 0.3 * random.uniform(0.3, 0.6);
  compressed.state.v = random_vector(random, 6);
  const Solution indefinite = solve(trial, compressed, 0.1, 0.1);
  trial.expect(indefinite.dv.allFinite(), "dv is not finite, where the matrix is not positive definite");
  const ImplicitSystem system = implicit_system(compressed, 0.1, 0.1);
  const bool solved = system.residual(indefinite.dv) <= kTolerance * system.rhs.norm() + system.rounding;
  trial.expect(indefinite.report.converged ? solved : true,
               "a solve that does not meet its tolerance is reported as converged");
  // The matrix has two different eigenvalues where particles are free: ConjGrad breaks down at the second direction at
  // the latest, and there is no use in another call.
  trial.expect(
      indefinite.report.steps <= 3 && indefinite.dfdx <= 7,
      "it goes on after ConjGrad broke down, where the matrix is not positive definite",
      std::to_string(indefinite.report.steps) + " steps, " + std::to_string(indefinite.dfdx) + " products");
  trial.expect_at_most(std::abs(indefinite.report.residual - system.residual(indefinite.dv)),
                       system.rounding + 1e-9 * system.residual(indefinite.dv),
                       "the error of the report's residual");
  // A force that is not a number is none that can be solved for.
  Cloud broken = chain(random, 8, 1, 10, 0.1);
  broken.state.x[4] = std::numeric_limits<double>::quiet_NaN();
  const Solution none = solve(trial, broken, 0.1, 0.1);
  trial.expect(!none.report.converged, "a system with numbers that are not finite is reported as solved");
  trial.expect(none.report.steps <= 1 && (none.dfdx <= 2 || none.dfdx >= 3 * broken.count() - 3),
               "it goes on after ConjGrad broke down, where numbers are not finite",
               std::to_string(none.report.steps) + " steps, " + std::to_string(none.dfdx) + " products");
  expect_end_of_rounding(trial);
}

}  // namespace

WholeRunPoints whole_run() {
  return {2, 3};
}

std::vector<Category> categories() {
  return {{"Matrix", "The matrix", 4, matrix},
          {"Damping", "Damping", 3, damping},
          {"Pinned", "Pinned particles", 3, pinned},
          {"Masses", "Masses", 2, masses},
          {"System", "The system, solved", 3, system},
          {"Step", "A step", 2, a_step},
          {"Tolerance", "The tolerance", 2, tolerance},
          {"Preconditioned", "A stiff hair, preconditioned", 2, preconditioned},
          {"Cost", "Evaluations and products", 2, cost},
          {"Revolution", "A revolution, an oscillation", 1, revolution},
          {"Unsolvable", "What can't be solved", 1, unsolvable}};
}

}  // namespace grader::h4

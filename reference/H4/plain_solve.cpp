// STAFF ONLY. H4: hidden cases of solve_plain. The matrices are ours, so that a mistake in another function
// costs nothing here.
//
// One category checks dv, to a hundredth; others check the tolerance and the report.
#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "reference/H4/answers.h"
#include "reference/H4/calls.h"

namespace grader::h4 {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTolerance = particles::kSolveTolerance;

struct System {
  std::string name;
  Eigen::MatrixXd A;
  Eigen::VectorXd rhs;

  double residual(const Eigen::VectorXd& dv) const { return (rhs - A * dv).norm(); }
  // The allowance for ConjGrad's residual (solver/linearSolver.h), as in implicit_system.h.
  double rounding(const Eigen::VectorXd& dv) const {
    const double e = static_cast<double>(rhs.size()) + 8;
    return 65 * (10 + 2 * e) * kUnit * A.norm() * (2 * dv.norm() + rhs.norm() / A.norm());
  }
};

struct Solution {
  particles::SolveReport report;
  Eigen::VectorXd rhs, dv;  // rhs as it is afterwards
  int products;             // the suite's own count
};

Solution solve(Trial& trial, const System& system, double tolerance, int most_steps, double junk = 1e3) {
  trial.describe(system.name);
  int products = 0;
  const int size = static_cast<int>(system.rhs.size());
  const Served matrix{size, size, [&](int, const std::vector<double>& x, std::vector<double>& y) {
                        if (static_cast<int>(x.size()) != size)
                          throw MalformedMessage("a question that makes no sense");
                        const VectorXd product = system.A * vector_of(x);
                        y.assign(product.begin(), product.end());
                        return ++products <= kMostQuestions;
                      }};
  const VectorXd there = VectorXd::Constant(size, junk);
  const auto [report, rhs, dv] =
      answer_of<Calls, particles::solve_plain>(trial, matrix, system.rhs, tolerance, most_steps, there);
  return {report, rhs, dv, products};
}

int most_of(const System& system) {
  return 20 * static_cast<int>(system.rhs.size());
}

// H diag(e) H for a reflection H, with eigenvalues from `least` to `most`, all different.
System system_of(Random& random, int size, double least, double most, double rhs) {
  VectorXd eigenvalues(size);
  for (int i = 0; i < size; ++i) eigenvalues[i] = least * std::pow(most / least, (i + 1.0) / size);
  const VectorXd w = random_vector(random, size).normalized();
  const MatrixXd H = MatrixXd::Identity(size, size) - 2 * w * w.transpose();
  const MatrixXd A = H * eigenvalues.asDiagonal() * H;
  return {"a system of " + std::to_string(size), 0.5 * (A + A.transpose()),
          rhs * random_vector(random, size).normalized()};
}

}  // namespace

void solve(Trial& trial) {
  Random& random = trial.random;
  for (int size : {3, 15, 60}) {
    const System system = system_of(random, size, 1, 30, random.uniform(0.5, 2));
    const Solution solution = solve(trial, system, kTolerance, most_of(system));
    // No eigenvalue is below 1, so dv is off by no more than the residual.
    trial.expect_at_most(system.residual(solution.dv), 1e-2 * system.rhs.norm(), "the residual of the system",
                         {solution.dv, system.A.llt().solve(system.rhs), 3, system.rhs});
    trial.expect(solution.rhs == system.rhs, "the right-hand side is changed");
  }
}

void tolerance(Trial& trial) {
  Random& random = trial.random;
  for (int size : {15, 60}) {
    const double unit = random.log_uniform(1e-14, 1e-7);
    const System system = system_of(random, size, 1e-7, 1e-5, unit);
    const Solution fine = solve(trial, system, kTolerance, most_of(system)),
                   coarse = solve(trial, system, 1e-2, most_of(system));
    trial.expect_at_most(system.residual(fine.dv), {kTolerance * unit, system.rounding(fine.dv)},
                         "the residual for a tolerance of 1e-10, where masses are those of hair");
    trial.expect_at_most(system.residual(coarse.dv), {1e-2 * unit, system.rounding(coarse.dv)},
                         "the residual for a tolerance of 0.01, where masses are those of hair");
    trial.expect(coarse.products < fine.products, "a tolerance of 1e-2 takes as many steps as one of 1e-10",
                 std::to_string(coarse.products) + " and " + std::to_string(fine.products) + " products");
  }
}

// The tolerance is loose and the right-hand side large, so that a program with another tolerance meets this
// one, too.
void report(Trial& trial) {
  Random& random = trial.random;
  const auto expect_true = [&](const System& system, const Solution& solution) {
    const particles::SolveReport& report = solution.report;
    trial.require(trial.provided_solves().size() == 1, "it does not call ConjGrad once");
    trial.expect_at_most(std::abs(report.rhs - system.rhs.norm()), 1e-12 * system.rhs.norm(),
                         "the error of the report's norm of the right-hand side");
    // The residual of dv, or the one that ConjGrad reported, if dv is lost.
    const double said = std::sqrt(trial.provided_solves().back().value);
    trial.expect_at_most(
        std::min(std::abs(report.residual - system.residual(solution.dv)), std::abs(report.residual - said)),
        system.rounding(solution.dv) + 1e-9 * said, "the error of the report's residual");
    const int steps = report.steps;
    trial.expect(solution.products == 1 + steps + steps / 64, "the report's steps are not ConjGrad's",
                 std::to_string(steps) + ", " + std::to_string(solution.products) + " products");
  };
  for (int size : {6, 60}) {
    const System system = system_of(random, size, 1, 1000, random.uniform(1e6, 2e6));
    const Solution solved = solve(trial, system, 1e-2, most_of(system));
    expect_true(system, solved);
    trial.expect(solved.report.converged, "a solve that meets its tolerance is reported as not converged");
    trial.expect(!solved.report.preconditioned, "a plain solve is reported as one with a preconditioner");
  }

  // With ten different eigenvalues and three steps the residual is never below 1e-3 of the right-hand side.
  const System hard = system_of(random, 12, 1, 1000, random.uniform(1e6, 2e6));
  const Solution few = solve(trial, hard, 1e-10, 3);
  expect_true(hard, few);
  trial.expect_at_most(std::abs(few.report.residual - hard.residual(few.dv)),
                       hard.rounding(few.dv) + 1e-9 * few.report.residual,
                       "the error of the report's residual where ConjGrad's limit ends it");
  trial.expect(few.report.steps == 3 && trial.provided_solves().back().most == 3,
               "ConjGrad may not take as many steps as the caller says",
               std::to_string(few.report.steps) + " steps of 3");
  trial.expect(!few.report.converged, "a solve that needs more steps is reported as converged");

  // The first direction, rhs, has rhs' A rhs < 0: ConjGrad ends at once.
  System indefinite = system_of(random, 12, 1, 10, random.uniform(1e6, 2e6));
  indefinite.name += ", not positive definite";
  indefinite.A *= -1;
  const Solution broke = solve(trial, indefinite, 1e-2, most_of(indefinite));
  trial.expect(!broke.report.converged, "a matrix that is not positive definite is reported as solved");
  trial.expect_at_most(broke.report.steps, {1, 0},
                       "the number of steps where the matrix is not positive definite");
  System unknown = hard;
  unknown.name += ", a number that is not finite";
  unknown.rhs[4] = std::numeric_limits<double>::quiet_NaN();
  const Solution none = solve(trial, unknown, 1e-2, most_of(unknown));
  trial.expect(!none.report.converged, "a system with numbers that are not finite is reported as solved");
}

void nothing(Trial& trial) {
  Random& random = trial.random;
  for (int size : {3, 15}) {
    System system = system_of(random, size, 1, 30, 1);
    system.rhs.setZero();
    const Solution solution = solve(trial, system, kTolerance, most_of(system), 0);
    trial.expect(solution.dv.isZero(0) && solution.report.steps == 0 && solution.report.residual == 0,
                 "a right-hand side of 0 does not give a dv of 0 after 0 steps");
    trial.expect(solution.report.converged, "a right-hand side of 0 is reported as not converged");
  }
}

// Powers of two change no rounding: only dv is multiplied by them. The matrix stays the same, since
// ConjGrad's first guess is the right-hand side.
void expect_same_solve_in_other_units(Trial& trial) {
  Random& random = trial.random;
  const System known = system_of(random, 15, 1, 30, 1);
  const Solution before = solve(trial, known, kTolerance, most_of(known));
  for (const double unit : {0x1p-200, 0x1p100}) {
    const System other{known.name + ", in another unit of length", known.A, unit * known.rhs};
    const Solution after = solve(trial, other, kTolerance, most_of(other), 1e3 * unit);
    trial.expect_close({after.dv / unit, before.dv}, 1e-6 * before.dv.norm(),
                       "how much a plain solve's dv changes in another unit of length");
    trial.expect(
        after.report.steps == before.report.steps && after.report.converged == before.report.converged,
        "another unit of length makes another solve",
        std::to_string(after.report.steps) + " steps, " + std::to_string(before.report.steps) + " before");
  }
}

}  // namespace grader::h4

// STAFF ONLY.
#include "grader/exercise/H4/answers.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "grader/exercise/H4/calls.h"
#include "grader/suite/case_asker.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;

int step_limit(const Cloud& cloud) {
  return std::max(100, 60 * cloud.count());
}

// More than honest solves can take, with two questions for each product.
int most_questions(const Cloud& cloud, int solves = 1) {
  return (2 * solves + 1) * (step_limit(cloud) + step_limit(cloud) / 64) + 6 * cloud.count() + 20;
}

constexpr Filling kScratch{particles::kImplicitScratch};

void count(Solution& solution, const ForceServer& server) {
  solution.forces = server.forces;
  solution.dfdx = server.dfdx;
  solution.dfdv = server.dfdv;
  solution.bands = server.bands;
}

}  // namespace

Solution solve(Trial& trial, const Cloud& cloud, double a, double b, double tolerance) {
  trial.describe(cloud.name + ", solve_implicit");
  // A tolerance that can't be met may be loosened to 1e-6, a hundred times each time: from 1e-10, or from next to nothing.
  const int solves = tolerance < kTolerance ? 7 : 3;
  ForceServer server(*cloud.force, cloud.count(), most_questions(cloud, solves));
  Solution solution;
  solution.dv = random_vector(trial.random, 3 * cloud.count(), 1e3);
  solution.report = ask_student_for<Calls, particles::solve_implicit>(
      trial, std::ref(server), cloud.particles, cloud.state, a, b, tolerance, solution.dv, kScratch);
  count(solution, server);
  return solution;
}

Solution step(Trial& trial, const Cloud& cloud, double h, double tolerance) {
  trial.describe(cloud.name + ", implicit_euler");
  ForceServer server(*cloud.force, cloud.count(), most_questions(cloud));
  Solution solution;
  particles::State state = cloud.state;
  solution.report = ask_student_for<Calls, particles::implicit_euler>(
      trial, std::ref(server), cloud.particles, h, tolerance, state, kScratch);
  solution.x = state.x;
  solution.v = state.v;
  solution.dv = solution.v - cloud.state.v;
  count(solution, server);
  return solution;
}

void expect_matrix(Trial& trial, const Cloud& cloud, double a, double b) {
  trial.describe(cloud.name + ", implicit_matrix");
  const int size = 3 * cloud.count();
  const ImplicitSystem system = implicit_system(cloud, a, b);
  const VectorXd x = random_vector(trial.random, size);
  for (double junk : {0.0, 1e3, std::numeric_limits<double>::quiet_NaN()}) {
    ForceServer server(*cloud.force, cloud.count(), 2 * size + 20);  // enough to write the matrix out
    CaseAsker asker(trial);
    const auto answer = Client<Calls, particles::implicit_matrix>::multiply(
        asker, 2, x, VectorXd::Constant(size, junk),
        std::tuple(std::ref(server), std::cref(cloud.particles), std::cref(cloud.state), a, b));
    const VectorXd &first = answer.products[0], &second = answer.products[1];
    // 3n terms in each of the two products, and what puts them together.
    trial.expect_at_most((first - system.A * x).norm(), 4 * (size + 8) * kUnit * system.norm * x.norm(),
                         "the error of the matrix' product");
    // The same x: a product that changes its input shows here.
    trial.expect(first == second, "the matrix' product is another one the second time");
  }
}

void expect_solves(Trial& trial, const ImplicitSystem& system, const VectorXd& dv, double tolerance) {
  const double allowed = tolerance * system.rhs.norm() + system.rounding;
  trial.expect_at_most(system.residual(dv), allowed, "the residual of the implicit step's system");
  trial.expect_at_most((dv - system.dv).norm(), allowed / system.smallest + 4 * kUnit * system.dv.norm(),
                       "the error of dv");
}

}  // namespace grader::h4

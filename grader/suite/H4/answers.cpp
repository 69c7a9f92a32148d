// STAFF ONLY.
#include "grader/suite/H4/answers.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "grader/play/force_server.h"
#include "grader/wire/particles_message.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;

constexpr int kProduct = 0, kSolve = 1, kEuler = 2;  // as in serve_H4.cpp

int step_limit(const Cloud& cloud) {
  return std::max(100, 60 * cloud.count());
}

// More than honest solves can take, with two questions for each product.
int most_questions(const Cloud& cloud, int solves = 1) {
  return (2 * solves + 1) * (step_limit(cloud) + step_limit(cloud) / 64) + 6 * cloud.count() + 20;
}

MessageWriter request(int function, const Cloud& cloud) {
  MessageWriter message;
  message.put(function);
  put(message, cloud.particles);
  put(message, cloud.state);
  return message;
}

}  // namespace

Solution solve(Trial& trial, const Cloud& cloud, double a, double b, double tolerance) {
  trial.describe(cloud.name + ", solve_implicit");
  MessageWriter message = request(kSolve, cloud);
  message.put(a).put(b).put(tolerance);
  put(message, random_vector(trial.random, 3 * cloud.count(), 1e3));
  // A tolerance that can't be met may be loosened to 1e-6, a hundred times each time: from 1e-10, or from next to nothing.
  const int solves = tolerance < kTolerance ? 7 : 3;
  ForceServer server(*cloud.force, cloud.count(), most_questions(cloud, solves));
  MessageReader reply = trial.ask(message, std::ref(server));
  Solution solution;
  solution.dv = get_vector(reply, 3 * cloud.count());
  solution.report = get_solve_report(reply);
  reply.expect_end();
  solution.forces = server.forces;
  solution.dfdx = server.dfdx;
  solution.dfdv = server.dfdv;
  solution.bands = server.bands;
  return solution;
}

Solution step(Trial& trial, const Cloud& cloud, double h, double tolerance) {
  trial.describe(cloud.name + ", implicit_euler");
  MessageWriter message = request(kEuler, cloud);
  message.put(h).put(tolerance);
  ForceServer server(*cloud.force, cloud.count(), most_questions(cloud));
  MessageReader reply = trial.ask(message, std::ref(server));
  Solution solution;
  solution.x = get_vector(reply, 3 * cloud.count());
  solution.v = get_vector(reply, 3 * cloud.count());
  solution.dv = solution.v - cloud.state.v;
  solution.report = get_solve_report(reply);
  reply.expect_end();
  solution.forces = server.forces;
  solution.dfdx = server.dfdx;
  solution.dfdv = server.dfdv;
  solution.bands = server.bands;
  return solution;
}

void expect_matrix(Trial& trial, const Cloud& cloud, double a, double b) {
  trial.describe(cloud.name + ", implicit_matrix");
  const int size = 3 * cloud.count();
  const ImplicitSystem system = implicit_system(cloud, a, b);
  const VectorXd x = random_vector(trial.random, size);
  for (double junk : {0.0, 1e3, std::numeric_limits<double>::quiet_NaN()}) {
    MessageWriter message = request(kProduct, cloud);
    message.put(a).put(b);
    put(message, x);
    put(message, VectorXd::Constant(size, junk));
    ForceServer server(*cloud.force, cloud.count(), 2 * size + 20);  // enough to write the matrix out
    MessageReader reply = trial.ask(message, std::ref(server));
    const VectorXd first = get_vector(reply, size), second = get_vector(reply, size);
    reply.expect_end();
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

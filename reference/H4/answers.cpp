// STAFF ONLY. Asks for the calls of H4.
#include "reference/H4/answers.h"

#include <functional>

#include "grader/judge/case_asker.h"
#include "grader/judge/rounding.h"
#include "reference/H4/calls.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;

// More than anybody takes who gets an answer: counts are asked for by a category of their own.
constexpr int kMostQuestions = 100'000;

ForceServer server_of(const Cloud& cloud) {
  return {*cloud.force, cloud.count(), kMostQuestions};
}

Asked asked_of(const ForceServer& server) {
  return {server.forces, server.dfdx, server.dfdv};
}

}  // namespace

Product multiply(Trial& trial, const Cloud& cloud, double a, double b, const VectorXd& x, double junk) {
  trial.describe(cloud.name + ", implicit_matrix");
  ForceServer server = server_of(cloud);
  CaseAsker asker(trial);
  auto answer = Client<Calls, particles::implicit_matrix>::multiply(
      asker, 2, x, VectorXd::Constant(x.size(), junk),
      std::tuple(std::ref(server), std::cref(cloud.particles), std::cref(cloud.state), a, b));
  return {answer.products[0], answer.products[1], answer.x, asked_of(server)};
}

RightSide right_side(Trial& trial, const Cloud& cloud, double a, double b, double junk) {
  trial.describe(cloud.name + ", implicit_rhs");
  ForceServer server = server_of(cloud);
  VectorXd rhs = VectorXd::Constant(cloud.state.x.size(), junk);
  ask_student_for<Calls, particles::implicit_rhs>(trial, std::ref(server), cloud.particles, cloud.state, a, b,
                                                  rhs);
  return {rhs, asked_of(server)};
}

Step step(Trial& trial, const Cloud& cloud, double h, double tolerance) {
  trial.describe(cloud.name + ", implicit_euler");
  ForceServer server = server_of(cloud);
  particles::State state = cloud.state;
  const particles::SolveReport report = ask_student_for<Calls, particles::implicit_euler>(
      trial, std::ref(server), cloud.particles, h, tolerance, state, Filling{particles::kImplicitScratch});
  return {state.x, state.v, report, asked_of(server)};
}

double System::rounding(const VectorXd& dv) const {
  const double e = static_cast<double>(rhs.size()) + 8;
  return 65 * (10 + 2 * e) * kUnit * A.norm() * (2 * dv.norm() + rhs.norm() / A.norm());
}

Solution solve(Trial& trial, const System& system, double tolerance, int most_steps, double junk) {
  trial.describe(system.name + ", solve_plain");
  int products = 0;
  const int size = static_cast<int>(system.rhs.size());
  const Served matrix{size, size, [&](int, const std::vector<double>& x, std::vector<double>& y) {
                        if (static_cast<int>(x.size()) != size)
                          throw MalformedMessage("a question that makes no sense");
                        const VectorXd product = system.A * to_vector(x);
                        y.assign(product.begin(), product.end());
                        return ++products <= kMostQuestions;
                      }};
  Solution solution{VectorXd::Constant(size, junk), system.rhs, {}, 0};
  solution.report = ask_student_for<Calls, particles::solve_plain>(trial, matrix, solution.rhs, tolerance,
                                                                   most_steps, solution.dv);
  solution.products = products;
  return solution;
}

}  // namespace grader::h4

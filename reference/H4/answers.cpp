// STAFF ONLY. Asks for the calls of H4.
#include "reference/H4/answers.h"

#include <functional>

#include "grader/judge/cases/case_asker.h"
#include "reference/H4/calls.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;

ForceServer server_of(const Cloud& cloud) {
  return {*cloud.force, cloud.count(), kMostQuestions};
}

Asked asked_of(const ForceServer& server) {
  return {server.forces, server.dfdx, server.dfdv};
}

}  // namespace

Product multiply(Trial& trial, const Cloud& cloud, double a, double b, const VectorXd& x, double junk) {
  trial.describe(cloud.name);
  ForceServer server = server_of(cloud);
  CaseAsker asker(trial);
  auto answer = Client<Calls, particles::implicit_matrix>::multiply(
      asker, 2, x, VectorXd::Constant(x.size(), junk),
      std::tuple(std::ref(server), std::cref(cloud.particles), std::cref(cloud.state), a, b));
  return {answer.products[0], answer.products[1], answer.x, asked_of(server)};
}

RightSide right_side(Trial& trial, const Cloud& cloud, double a, double b, double junk) {
  trial.describe(cloud.name);
  ForceServer server = server_of(cloud);
  const VectorXd there = VectorXd::Constant(cloud.state.x.size(), junk);
  const VectorXd rhs = answer_of<Calls, particles::implicit_rhs>(trial, std::ref(server), cloud.particles,
                                                                 cloud.state, a, b, there);
  return {rhs, asked_of(server)};
}

Step step(Trial& trial, const Cloud& cloud, double h, double tolerance) {
  trial.describe(cloud.name);
  ForceServer server = server_of(cloud);
  const auto [report, state] = answer_of<Calls, particles::implicit_euler>(
      trial, std::ref(server), cloud.particles, h, tolerance, cloud.state, Filling{});
  return {state.x, state.v, report, asked_of(server)};
}

}  // namespace grader::h4

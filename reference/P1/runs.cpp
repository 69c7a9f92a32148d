// STAFF ONLY. Asks a student for steps of P1, one or many.
#include "reference/P1/runs.h"

#include <functional>

#include "reference/P1/calls.h"

namespace grader::p1 {
namespace {

using Eigen::VectorXd;

template <auto function>
Method method(const char* name, int evaluations, int order) {
  return {name, evaluations, order, function,
          [](CaseAsker& asker, DynamicsServer& server, double h, VectorXd& x, VectorXd& v,
             const Filling& scratch) { ask<Calls, function>(asker, std::ref(server), h, x, v, scratch); }};
}

}  // namespace

const Method kMethods[4] = {method<particles::forward_euler>("forward_euler", 1, 1),
                            method<particles::symplectic_euler>("symplectic_euler", 1, 1),
                            method<particles::midpoint>("midpoint", 2, 2),
                            method<particles::runge_kutta_4>("runge_kutta_4", 4, 4)};

Run run(Trial& trial, const Method& method, particles::Dynamics& dynamics, const State& start,
        const Setting& setting) {
  const int n = static_cast<int>(start.x.size()) / 3;
  trial.describe(std::to_string(setting.steps) + " steps, scratch with " +
                 std::to_string(setting.scratch.number));
  // The limit is ten times the need, since the evaluations have a category of their own.
  DynamicsServer server(dynamics, n, 10 * method.evaluations * setting.steps);
  CaseAsker asker(trial, "evaluates the acceleration far more often than it should");
  Run result;
  State state = start;
  for (int step = 0; step < setting.steps; ++step) {
    method.ask(asker, server, setting.h, state.x, state.v, setting.scratch);
    result.states.push_back(state);
  }
  result.evaluations = server.evaluations;
  return result;
}

}  // namespace grader::p1

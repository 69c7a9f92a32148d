// STAFF ONLY. The student's integrators, run through the pipe with accelerations that the suite serves.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "grader/calls/object_servers.h"
#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "reference/P1/calls.h"

namespace grader::p1 {

using Eigen::VectorXd;

struct Method {
  const char* name;
  int evaluations, order;
  void (*reference)(particles::Dynamics&, double, particles::Output, particles::Output, particles::Scratch);
  // Asks for one step of the student's.
  void (*ask)(CaseAsker&, DynamicsServer&, double h, VectorXd& x, VectorXd& v, const Filling& scratch);
};

template <auto function>
Method method(const char* name, int evaluations, int order) {
  return {name, evaluations, order, function,
          [](CaseAsker& asker, DynamicsServer& server, double h, VectorXd& x, VectorXd& v,
             const Filling& scratch) { ask<Calls, function>(asker, std::ref(server), h, x, v, scratch); }};
}

inline const Method kMethods[4] = {method<particles::forward_euler>("forward_euler", 1, 1),
                                   method<particles::symplectic_euler>("symplectic_euler", 1, 1),
                                   method<particles::midpoint>("midpoint", 2, 2),
                                   method<particles::runge_kutta_4>("runge_kutta_4", 4, 4)};

struct State {
  VectorXd x, v;
};

inline State random_state(Random& random, int n) {
  return {random_vector(random, 3 * n), random_vector(random, 3 * n)};
}

struct Run {
  std::vector<State> states;  // after each step
  int evaluations = 0;

  const State& end() const { return states.back(); }
};

struct Setting {
  double h;
  int steps = 1;
  Filling scratch = {0, 0};
};

// Runs the student's steps.
inline Run run(Trial& trial, const Method& method, particles::Dynamics& dynamics, const State& start,
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

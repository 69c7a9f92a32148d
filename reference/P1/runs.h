// STAFF ONLY. The student's integrators, run through the pipe with accelerations that the suite serves.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "grader/calls/object_servers.h"
#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "particles/explicit_integrators.h"

namespace grader::p1 {

struct Method {
  const char* name;
  int evaluations, order;
  void (*reference)(particles::Dynamics&, double, particles::Output, particles::Output, particles::Scratch);
  // Asks for one step of the student's.
  void (*ask)(CaseAsker&, DynamicsServer&, double h, Eigen::VectorXd& x, Eigen::VectorXd& v,
              const Filling& scratch);
};

extern const Method kMethods[4];

struct State {
  Eigen::VectorXd x, v;
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
Run run(Trial& trial, const Method& method, particles::Dynamics& dynamics, const State& start,
        const Setting& setting);

}  // namespace grader::p1

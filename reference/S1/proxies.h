// STAFF ONLY. ConjGrad, asked of somebody else by the call with lengths.
#pragma once

#include <stdexcept>

#include "grader/calls/remote.h"

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  if (n < 0) throw std::invalid_argument("ConjGrad of " + std::to_string(n) + " unknowns");
  Eigen::Map<Eigen::VectorXd> solution(x, n);
  Eigen::VectorXd right_hand_side = Eigen::Map<Eigen::VectorXd>(b, n);
  int taken = *steps;
  const double value = grader::proxied<grader::s1::Calls, grader::s1::conj_grad>(
      grader::Operator{n, n, A}, solution, right_hand_side, epsilon, taken);
  grader::bound_steps(taken);
  *steps = taken;
  grader::poison_overlap(b, n, x, n);
  return value;
}

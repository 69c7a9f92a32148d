// The parameters of a step, common to all methods.
#pragma once

namespace particles {

struct StepOptions {
  double h;          // s
  double tolerance;  // relative tolerance of implicit solves
};

}  // namespace particles

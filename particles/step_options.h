// What all methods are told of a step.
#pragma once

namespace particles {

struct StepOptions {
  double h;          // s
  double tolerance;  // of implicit solves, relative
};

}  // namespace particles

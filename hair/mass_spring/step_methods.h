// How one strand takes one step: the exercises' methods behind one signature.
#pragma once

#include "hair/mass_spring/moving_strand.h"
#include "hair/strand/blow_up.h"
#include "particles/step_options.h"

namespace hair {

using particles::StepOptions;

// What a step took, and where it went wrong if it did.
struct StepOutcome {
  long solver_steps = 0;               // of ConjGrad
  int unconverged = 0;                 // solves and corrections that ended above their tolerance
  long correction_steps = 0;           // Newton steps: of the length correction, or of newton_euler
  long halvings = 0;                   // of newton_euler's steps: each evaluates the forces once more
  Stage suspect = Stage::integration;  // where numbers stopped being finite; else the last stage
};

struct StepMethod {
  StepOutcome (*step)(MovingStrand&, const StepOptions&, const particles::Scratch&);
  int scratch;  // columns of 3n numbers

  // Null, or brings a strand back to what the method promises after something else moved it: a collision.
  void (*mend)(MovingStrand&, const particles::Scratch&) = nullptr;

  // It takes the exact derivative's products, and definite ones beside them: MovingStrand::definite_force.
  bool needs_definite_force = false;
};

// Of P1's methods, H4's and H6's: there if the course has the exercise.
extern const StepMethod kForwardEuler, kSymplecticEuler, kMidpoint, kRungeKutta4;
extern const StepMethod kImplicitEuler, kNewtonEuler;
extern const StepMethod kPredictorCorrector;

}  // namespace hair

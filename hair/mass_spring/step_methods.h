// One step of one strand: the exercises' methods behind one signature.
#pragma once

#include "hair/mass_spring/moving_strand.h"
#include "hair/strand/blow_up.h"
#include "particles/implicit_euler.h"
#include "particles/step_options.h"

namespace hair {

using particles::StepOptions;

// The effort of a step, and the stage of a failure.
struct StepOutcome {
  long solver_steps = 0;               // iterations of ConjGrad
  int plain_solves = 0;                // solves that had no preconditioner
  int solves = 0;                      // solves and corrections
  int unconverged = 0;                 // those that ended above their tolerance
  double residual = 0;                 // the largest of these solves, relative to its right-hand side
  long correction_steps = 0;           // Newton steps of the length correction
  Stage suspect = Stage::integration;  // where numbers stopped being finite; otherwise the last stage
};

// What a solve that ended above its tolerance left, relative to its right-hand side; 0 of one that did not.
inline double left_by(const particles::SolveReport& report) {
  return report.converged ? 0 : report.residual / report.rhs;
}

// Of one implicit solve.
inline StepOutcome outcome_of(const particles::SolveReport& report) {
  return {.solver_steps = report.steps,
          .plain_solves = !report.preconditioned,
          .solves = 1,
          .unconverged = !report.converged,
          .residual = left_by(report),
          .suspect = Stage::filter};
}

struct StepMethod {
  StepOutcome (*step)(MovingStrand&, const StepOptions&, const particles::Scratch&);
  int scratch;  // columns of 3n numbers

  // Null, or restores the method's invariants after something else moved the strand: a collision.
  void (*mend)(MovingStrand&, const particles::Scratch&) = nullptr;

  // Its steps keep lengths.
  bool keeps_lengths = false;

  // It moves particles straight on instead of round: the books of energy leave stretching out
  // (spring_energy.h).
  bool goes_straight_on = false;

  // So many steps are read as one by these books.
  int read_every = 1;
};

// The methods of H4 and H6; those of P1: explicit_step.h.
extern const StepMethod kImplicitEuler;
extern const StepMethod kPredictorCorrector;

}  // namespace hair

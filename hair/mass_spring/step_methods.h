// One step of one strand: the exercises' methods behind one signature.
#pragma once

#include "hair/mass_spring/moving_strand.h"
#include "hair/strand/blow_up.h"
#include "particles/implicit_euler.h"
#include "particles/system.h"

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
  Stage suspect = Stage::integration;  // stage of the first number that is not finite; else the last one
};

// The residual of a solve that ended above its tolerance, relative to its right-hand side; otherwise 0.
inline double left_by(const particles::SolveReport& report) {
  return report.converged ? 0 : report.residual / report.rhs;
}

// The outcome of one implicit solve.
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

  // Null, or restores the method's invariants after a collision moved the strand.
  void (*mend)(MovingStrand&, const particles::Scratch&) = nullptr;

  // Its steps preserve lengths.
  bool keeps_lengths = false;

  // It moves particles along straight lines, so the energy balance leaves stretching out (SpringEnergy).
  bool goes_straight_on = false;

  // The energy balance reads so many steps as one.
  int read_every = 1;
};

// The methods of H4 and H6; those of P1: hair/simulation/methods.cpp.
extern const StepMethod kImplicitEuler;
extern const StepMethod kPredictorCorrector;

}  // namespace hair

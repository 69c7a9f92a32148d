// STAFF ONLY. Cases of P2 that stand in files of their own.
#pragma once

#include "grader/judge/trial.h"

namespace grader::p2 {

// Each sends its cases to the student's functions and throws CaseFailed at the first failure.
void rod_values(Trial& trial);
void wire_values(Trial& trial);
void rod_forces(Trial& trial);
void wire_forces(Trial& trial);
void matrix(Trial& trial);
void constraint_forces(Trial& trial);
void feedback(Trial& trial);
void pinned_particles(Trial& trial);
void nothing_to_hold(Trial& trial);
void rods_and_wires(Trial& trial);
void small_unit(Trial& trial);
void tolerance_and_report(Trial& trial);

}  // namespace grader::p2

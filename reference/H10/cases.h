// STAFF ONLY. Cases of H10 that stand in files of their own.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h10 {

// Each sends its cases to the student's functions and throws CaseFailed at the first failure.
void weights_inside(Trial& trial);
void weights_outside(Trial& trial);
void thin_triangles(Trial& trial);
void no_width(Trial& trial);
void weights_in_other_units(Trial& trial);  // a part of other_units
void flat_scalp(Trial& trial);
void curved_scalp(Trial& trial);
void arcs(Trial& trial);
void carried_turns(Trial& trial);
void folds(Trial& trial);
void wisps(Trial& trial);
void spreading(Trial& trial);
void blends(Trial& trial);
void other_units(Trial& trial);

}  // namespace grader::h10

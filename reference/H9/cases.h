// STAFF ONLY. Cases of H9 that stand in files of their own.
#pragma once

#include "grader/judge/trial.h"

namespace grader::h9 {

// Each sends its cases to the student's functions and throws CaseFailed at the first failure.
void strengths(Trial& trial);
void histories(Trial& trial);
void link_energies(Trial& trial);
void link_forces(Trial& trial);
void turned_frames(Trial& trial);
void worn_links(Trial& trial);
void link_products(Trial& trial);
void added(Trial& trial);
void touches(Trial& trial);
void flat_triangles(Trial& trial);
void weights(Trial& trial);
void no_directions(Trial& trial);
void strip_forces(Trial& trial);
void strip_products(Trial& trial);
void frictions(Trial& trial);
void pinned_frictions(Trial& trial);
void friction_order(Trial& trial);
void other_units(Trial& trial);

}  // namespace grader::h9

// STAFF ONLY. Wrong programs that are made of an exercise's solution, and a judge that should find each. The
// environment's HAIR_MUTANTS says how many are tried (40), HAIR_MUTANTS_SEED which (1); HAIR_TOLD names a
// folder for what was changed in each.
#pragma once

#include <functional>
#include <string>

#include "grader/course/course.h"
#include "grader/mutants/judgement.h"

namespace grader {

// Of the file `source` of the submission `name`. Threads call it side by side, with different names.
using Judge = std::function<Judged(const std::string& name, const std::string& source)>;

// Fails for a wrong program that the judge gives all points, and for a right one
// (reference/<ID>/equivalents.json) that loses some. `advice` says in a failure what to do about a wrong one
// that is not found.
void expect_mutants_found(const Exercise& exercise, const Judge& judge, const std::string& advice);

}  // namespace grader

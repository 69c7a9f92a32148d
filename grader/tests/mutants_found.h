// STAFF ONLY. Makes wrong programs of an exercise's solution, which a judge should find. The environment's
// HAIR_MUTANTS sets their number (40), HAIR_MUTANTS_SEED the seed (1); HAIR_TOLD names a folder for each
// program's change.
#pragma once

#include <functional>
#include <string>

#include "grader/course/course.h"
#include "grader/mutants/judging.h"

namespace grader {

// Judges the file `source` of the submission `name`. Threads call it in parallel, with different names.
using Judge = std::function<Judged(const std::string& name, const std::string& source)>;

// Fails for a wrong program that the judge gives all points, and for a right one
// (reference/<ID>/equivalents.json) that loses some. A failure says `advice` about a wrong program that was
// not found.
void expect_mutants_found(const Exercise& exercise, const Judge& judge, const std::string& advice);

}  // namespace grader

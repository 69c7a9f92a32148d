// STAFF ONLY. The judgement of a wrong program.
#pragma once

#include <vector>

#include "grader/result/result.h"

namespace grader::inline mutants {

enum class Judgement { does_not_compile, loses_points, gets_all };

struct Judged {
  Judgement judgement = Judgement::does_not_compile;
  // Lists categories, also the whole run; empty if they were not counted.
  std::vector<CaseResult> lost = {};
};

}  // namespace grader::mutants

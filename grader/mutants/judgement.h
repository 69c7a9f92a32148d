// STAFF ONLY. What becomes of a wrong program.
#pragma once

#include <vector>

#include "grader/result/result.h"

namespace grader::inline mutants {

enum class Judgement { does_not_compile, loses_points, gets_all };

struct Judged {
  Judgement judgement = Judgement::does_not_compile;
  // Categories, the whole run among them; none where they were not counted.
  std::vector<CaseResult> lost = {};
};

}  // namespace grader::mutants

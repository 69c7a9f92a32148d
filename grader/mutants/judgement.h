// STAFF ONLY. What becomes of a wrong program.
#pragma once

namespace grader {

enum class Judgement { does_not_compile, loses_points, gets_all };

struct Judged {
  Judgement judgement = Judgement::does_not_compile;
  int lost = 0;  // categories, the whole run among them; 0 where they were not counted
};

}  // namespace grader

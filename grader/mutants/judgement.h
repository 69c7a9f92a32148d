// STAFF ONLY. What becomes of a wrong program.
#pragma once

namespace grader {

enum class Judgement { does_not_compile, loses_points, gets_all };

}  // namespace grader

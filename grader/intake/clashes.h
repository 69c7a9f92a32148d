// STAFF ONLY. Separates submissions that get the same name. Owners whose names differ ("x 1" and "x_1") get
// names of their own. If the owner is the same (x.zip and x.tar.gz), it is unclear which one counts:
// none is graded; all others are. An argument keeps its name if a member of a class has the same one.
#pragma once

#include <string>
#include <vector>

#include "grader/intake/draft.h"

namespace grader::inline intake {

// Sorts by name, whatever the order was before. Leaves out repetitions. Submissions with the same name each
// get a name of their own, a problem that names another of them, and a notice.
void resolve_clashes(std::vector<Draft>& drafts, std::vector<std::string>& notices);

}  // namespace grader::intake

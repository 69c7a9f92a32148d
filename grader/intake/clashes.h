// STAFF ONLY. Submissions that end up with the same name. Owners whose names differ ("x 1" and "x_1") get
// names of their own. Where the owner is the same (x.zip and x.tar.gz) nobody can say which of them is meant,
// so none of them is graded; all others are. An argument stands beside members of a class.
#pragma once

#include <string>
#include <vector>

#include "grader/intake/draft.h"

namespace grader::inline intake {

// Sorts by name, whatever the order was before. Leaves out what was given twice. Submissions of one name each
// get a name of their own, a problem that names another of them, and a notice.
void resolve_clashes(std::vector<Draft>& drafts, std::vector<std::string>& notices);

}  // namespace grader::intake

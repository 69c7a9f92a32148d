// STAFF ONLY. Submissions that end up with the same name: "x 1" and "x_1", x.zip and x.tar.gz. Nobody can say
// which of them is meant, so none of them is graded; all others are. An argument stands beside members of a class.
#pragma once

#include <string>
#include <vector>

#include "grader/intake/draft.h"

namespace grader {

// Sorts by name, whatever the order was before. Leaves out what was given twice. Submissions of one name each
// get a name of their own, a problem that names another of them, and a notice.
void resolve_clashes(std::vector<Draft>& drafts, std::vector<std::string>& notices);

}  // namespace grader

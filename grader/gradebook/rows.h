// STAFF ONLY. Gradebooks with rows of their own, for systems that take those, and for people.
#pragma once

#include "grader/gradebook/filling.h"

namespace grader::inline gradebook {

// Writes Brightspace's import: its ids as exported, the points of an existing item, and its mark at the
// end of each row.
Gradebook fill_brightspace(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options);

// Writes Autolab's bulk grades: no titles; e-mail, a value for each of the lab's problems in their order,
// "excused". `problems` are ids of exercises, or "total".
Gradebook autolab_rows(const std::vector<Grade>& grades, const std::vector<std::string>& problems,
                       const Roster* roster);

// Lists everybody of the exported table, or without one everybody with a grade, for people. No source
// confirms an import by `system`, and the table says so.
Gradebook plain_rows(const std::string& system, const Csv* exported, const std::vector<Grade>& grades,
                     const FillOptions& options);

}  // namespace grader::gradebook

// STAFF ONLY. Fills in Blackboard's Grade Center, in its own form.
#pragma once

#include "grader/gradebook/filling.h"

namespace grader::inline gradebook {

// Keeps the download's encoding and separator; rows without a grade keep their bytes. The column is found by
// its number or title, and has a number. Cells with words, such as "Needs Grading", stay; if there is a
// column "Feedback to Learner", the first lines of the report go there.
Gradebook fill_blackboard(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options);

}  // namespace grader::gradebook

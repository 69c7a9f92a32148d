// STAFF ONLY. Blackboard's Grade Center, filled in as it was downloaded.
#pragma once

#include "grader/gradebook/filling.h"

namespace grader::inline gradebook {

// In the download's encoding and separator; rows that get no grade are the same bytes. The column is found by
// its number or title, and has a number. Cells with words, such as "Needs Grading", stay; where there is a
// column "Feedback to Learner", the first lines of the report go there.
Gradebook fill_blackboard(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options);

}  // namespace grader::gradebook

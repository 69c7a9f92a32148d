// STAFF ONLY. The part of a result that a student may see. Code that runs in the sandbox knows hidden inputs,
// and could choose how it fails in each category to carry them out. So a category is right, wrong or broke
// off; a wrong one says in one of a few fixed sentences that nearly all of its cases hold, some or hardly
// any; and a picture of a run that is far off is coarse. Staff see all.
#pragma once

#include "grader/result/result.h"

namespace grader::inline report {

// Keeps the points; removes details and logs.
SubmissionResult for_student(const SubmissionResult& result);

}  // namespace grader::report

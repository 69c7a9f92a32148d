// STAFF ONLY. What a student may see of a result. Code that runs in the sandbox knows hidden inputs, and it could choose
// how it fails, category by category, to carry them out. So a category is right, wrong or broke off, in a fixed
// sentence, and a picture of a run that is far from the reference's is coarse. Staff see all.
#pragma once

#include "grader/report/result.h"

namespace grader {

// The same points; without details and logs.
SubmissionResult for_student(const SubmissionResult& result);

}  // namespace grader

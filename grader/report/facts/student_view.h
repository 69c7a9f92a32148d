// STAFF ONLY. The part of a result that a student may see. Code that runs in the sandbox knows hidden inputs,
// and could choose how it fails in each category to carry them out. So a category is right, wrong or broke
// off; a wrong one says in one of a few fixed sentences that nearly all of its cases hold, some or hardly
// any; and a picture of a run that is far off is coarse. A memory error is finer: students see its kind and
// its line, which code may choose from a short list of ours and from its own file. Staff see all.
#pragma once

#include "grader/result/result.h"

namespace grader::inline report {

// Keeps the points; removes details and logs.
SubmissionResult for_student(const SubmissionResult& result);

}  // namespace grader::report

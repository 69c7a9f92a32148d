// STAFF ONLY. What a student may see of a result. Code that runs in the sandbox knows hidden inputs, and it
// could choose how it fails, category by category, to carry them out. So a category is right, wrong or broke
// off, and if it is wrong, nearly all of its cases hold, some or hardly any: one of a few fixed sentences;
// and a picture of a run that is far from the reference's is coarse. A memory error is finer: they see its
// kind and its line, which code may choose from a short list of ours and from its own file. Staff see all.
#pragma once

#include "grader/result/result.h"

namespace grader {

// The same points; without details and logs.
SubmissionResult for_student(const SubmissionResult& result);

}  // namespace grader

// STAFF ONLY. Made-up results for tests.
#pragma once

#include <string>
#include <vector>

#include "grader/report/result.h"

namespace grader {

constexpr Status all_statuses[] = {Status::passed,          Status::partly,    Status::wrong,
                                   Status::not_implemented, Status::missing,   Status::does_not_compile,
                                   Status::crashed,         Status::timed_out, Status::out_of_memory,
                                   Status::broke_rules};

// A moment of strands, the student's moved to the right by so many pixels.
PictureResult sample_picture(const std::string& name, int shift, double limit);

// A class of `size` in which every status occurs, from the tenth submission on twice, and so forth. What runs
// has pictures: the same if it passed, near if it partly did, far if it is wrong.
std::vector<SubmissionResult> sample_class(int size);

// The same with the course's ten exercises in each, two of them extra credit.
std::vector<SubmissionResult> class_of_ten_exercises(int size);

// A submission whose every text is `text`, staff's texts too.
SubmissionResult submission_full_of(const std::string& text);

}  // namespace grader

// STAFF ONLY. Makes synthetic results for tests, and looks for parts of their pages.
#pragma once

#include <string>
#include <vector>

#include "grader/result/result.h"

namespace grader::inline report {

constexpr Status all_statuses[] = {Status::passed,          Status::partly,    Status::wrong,
                                   Status::not_implemented, Status::missing,   Status::does_not_compile,
                                   Status::crashed,         Status::timed_out, Status::out_of_memory,
                                   Status::broke_rules,     Status::not_taken, Status::unreadable};

// Makes a moment with strands; the student's are moved to the right by `shift` pixels.
PictureResult sample_picture(const std::string& name, int shift);

// Makes motions of two strands, 10 frames long. From frame 5 on the student's tips are off by `off` m.
RunMotions sample_motions(double off);

// Makes a class of `size` submissions. Each of ten has another status; the fifteenth can't be read. Results
// that run have pictures: the same if it passed, near if it passed partly, far if it is wrong.
std::vector<SubmissionResult> sample_class(int size);

// Makes the same with the course's ten exercises for each submission, two of them extra credit.
std::vector<SubmissionResult> class_of_ten_exercises(int size);

// Makes four submissions. A person excused the first from P1 and the last from all, set points of the second
// with a comment, and of the third where other points are computed now.
std::vector<SubmissionResult> class_with_decisions();

// Makes a submission in which every text is `text`, including the staff's.
SubmissionResult submission_full_of(const std::string& text);

// Counts a part in a text.
std::size_t times(const std::string& text, const std::string& part);

// Expects that the parts follow one another.
void expect_in_order(const std::string& text, const std::vector<std::string>& parts);

}  // namespace grader::report

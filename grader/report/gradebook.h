// STAFF ONLY. The class for other programs: a table for a spreadsheet, test results for a build server.
#pragma once

#include <string>
#include <vector>

#include "grader/report/result.h"

namespace grader {

// RFC 4180. A line a submission: name, total, points to reach, whether a sandbox held it, whether its
// pictures were graded, then points and status of each exercise, then what is wrong with it as a whole. A
// cell that a spreadsheet would run as a formula begins with ' instead.
std::string grades_csv(const std::vector<SubmissionResult>& results);

// A suite a submission, a case a category; "S1" alone for an exercise without categories. What a student did
// not hand in or not begin is skipped, wrong answers are failures, what ended a program is an error.
std::string junit_xml(const std::vector<SubmissionResult>& results);

}  // namespace grader

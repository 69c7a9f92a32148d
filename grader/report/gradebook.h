// STAFF ONLY. The class's results for other programs: a table for a spreadsheet, test results for a build
// server.
#pragma once

#include <string>
#include <vector>

#include "grader/report/course_table.h"
#include "grader/result/result.h"
#include "grader/roster/class_list.h"

namespace grader::inline report {

// RFC 4180. A line for each submission: name, total, maximum without extra credit, whether it ran in a
// sandbox, whether its pictures were graded, then points and status of each exercise, then the note on the
// whole submission. No spreadsheet runs a cell as a formula, see grader/text/csv.h.
//
// With `people` each of them has a line, with name, id, e-mail, section and what is said of them at its end:
// several of a group's hand-in, and one without points of who handed nothing in.
std::string grades_csv(const std::vector<SubmissionResult>& results,
                       const std::vector<ClassLine>& people = {});

// A suite for each submission, a case for each category; only "S1" for an exercise without categories. An
// exercise that was not handed in or not begun is skipped, a wrong answer is a failure, and a program that
// ended early or a submission that can't be read is an error.
std::string junit_xml(const std::vector<SubmissionResult>& results);

// A course's: total and points of each hand-in.
std::string course_csv(const CourseTable& course, const std::vector<ClassLine>& people);

}  // namespace grader::report

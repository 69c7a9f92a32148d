// STAFF ONLY. The class's results for other programs: a table for a spreadsheet, test results for a build
// server.
#pragma once

#include <string>
#include <vector>

#include "grader/report/facts/class_facts.h"
#include "grader/result/result.h"
#include "grader/roster/class_list.h"

namespace grader::inline report {

// RFC 4180. A line for each submission: name, total, maximum without extra credit, in a sandbox or not, with
// graded pictures or not, then points and status of each exercise, then the note on the whole submission, and
// decisions of people. No spreadsheet runs a cell as a formula, see grader/text/csv.h.
//
// With `people` each of them has a line, which ends with name, id, e-mail, section and a remark: a group's
// hand-in has several lines, and a person without a hand-in has a line without points.
std::string grades_csv(const std::vector<SubmissionResult>& results,
                       const std::vector<ClassLine>& people = {});

// Writes a suite for each submission, a case for each category; only "S1" for an exercise without categories.
// An exercise that was not handed in or not begun is skipped, a wrong answer is a failure, and a program that
// ended early or a submission that can't be read is an error.
std::string junit_xml(const std::vector<SubmissionResult>& results);

// Writes a course's totals and the points of each hand-in.
std::string course_csv(const CourseTable& course, const std::vector<ClassLine>& people);

}  // namespace grader::report

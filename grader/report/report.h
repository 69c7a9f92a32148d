// STAFF ONLY. Results on paper. Every file is written under a temporary name and renamed. The same results give the same bytes.
//
//   DIR/NAME/results.json  Gradescope's schema, for the student
//   DIR/NAME/report.html   for the student
//   DIR/staff/NAME.html    for staff: inputs, expected and actual values, what compiler and worker printed
//   DIR/grades.csv, index.html, junit.xml  the class
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <vector>

#include "grader/report/result.h"

namespace grader {

void write_submission_reports(const std::filesystem::path& dir, const SubmissionResult& result);
void write_class_reports(const std::filesystem::path& dir, const std::vector<SubmissionResult>& results);

// What write_submission_reports wrote for `name` in `dir`, read back; nothing if there is none or it can't be read. The staff's part comes back, too.
std::optional<SubmissionResult> read_results(const std::filesystem::path& dir, const std::string& name);

// The class as a table for a terminal: a line a submission, a column an exercise.
void print_table(std::ostream& out, const std::vector<SubmissionResult>& results);

}  // namespace grader

// STAFF ONLY. Results on paper. Every file is written under a temporary name and renamed; what can't be
// written is BadInput with path and reason. The same results give the same bytes: no dates, no times, no
// paths.
//
//   DIR/NAME/results.json  Gradescope's schema, for the student
//   DIR/NAME/report.html   for the student
//   DIR/staff/NAME.html    for staff: inputs, expected and actual values, what compiler and worker printed
//   DIR/staff/NAME.json    all of it, from which --resume goes on
//   DIR/staff/pictures/    the pictures that both show, each once for the class; see picture_files.h
//   DIR/NAME/study.html, study.json  with studies: error against time; the only ones of these with measured times in them
//   DIR/grades.csv, index.html, junit.xml  the class
//
// Text of students is escaped for what it is written into: invalid UTF-8, control characters and terminal
// colours can't pass, pages run no script of theirs and load nothing.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "grader/report/result.h"
#include "grader/report/study_result.h"

namespace grader {

// Throws std::invalid_argument for a name that intake can't have given: empty, with '/', with a dot in front,
// "staff".
void write_submission_reports(const std::filesystem::path& dir, const SubmissionResult& result);
// Its pages of a study, before its reports, which lead to them if result.studied; and away with those that there are.
void write_study(const std::filesystem::path& dir, const SubmissionResult& result,
                 const SubmissionStudy& study, const SubmissionStudy& beside_itself);
void remove_study(const std::filesystem::path& dir, const SubmissionResult& result);

void write_class_reports(const std::filesystem::path& dir, const std::vector<SubmissionResult>& results);

// What write_submission_reports wrote for `name` in `dir`, read back, the staff's part included; nothing if a
// file of it is missing or can't be read, or if a picture is not what it was.
std::optional<SubmissionResult> read_results(const std::filesystem::path& dir, const std::string& name);

// The class as a table for a terminal: a line a submission, a column an exercise. ASCII, no colours.
void print_table(std::ostream& out, const std::vector<SubmissionResult>& results);

}  // namespace grader

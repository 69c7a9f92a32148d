// STAFF ONLY. Writes results to files. Every file is written under a temporary name and renamed; a file that
// can't be written throws BadInput with path and reason. The same results give the same bytes: no dates, no
// times, no paths.
//
//   DIR/NAME/results.json  Gradescope's schema, for the student
//   DIR/NAME/report.html   for the student
//   DIR/staff/NAME.html    for staff: inputs, expected and actual values, output of compiler and worker
//   DIR/staff/NAME.json    the whole result
//   DIR/staff/pictures/    the pictures of these two, each stored once for the class; see picture_files.h
//   DIR/staff/runs/NAME/H4.html  its run beside the reference's, if they look different
//   DIR/NAME/study.html, study.json  only with studies: error against time; the only files here with times
//   DIR/grades.csv, index.html  the class
//
// Students' text is escaped for each format: invalid UTF-8, control characters and terminal colours are
// removed; pages run none of their scripts and load nothing.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "grader/report/facts/class_facts.h"
#include "grader/result/result.h"
#include "grader/result/study.h"

namespace grader::inline report {

// Throws std::invalid_argument for a name that intake never gives: empty, with '/', with a leading dot, or
// "staff". Reports show the names in `people`, and the folder's name, too, for staff.
void write_submission_reports(const std::filesystem::path& dir, const SubmissionResult& result,
                              const NamesForPeople& people = {});
// write_study writes the pages of a study, before the reports, which link to them if result.studied.
// remove_study removes them.
void write_study(const std::filesystem::path& dir, const SubmissionResult& result,
                 const SubmissionStudy& study, const NamesForPeople& people = {});
void remove_study(const std::filesystem::path& dir, const SubmissionResult& result);

void write_class_reports(const std::filesystem::path& dir, const std::vector<SubmissionResult>& results,
                         const ClassFacts& facts = {}, const NamesForPeople& people = {});

// Writes the course's grades.csv and index.html, above the folders of its hand-ins.
void write_course_reports(const std::filesystem::path& dir, const CourseTable& course,
                          const std::vector<ClassLine>& lines, const NamesForPeople& people = {});

// Removes all files of a student in `dir`, except pictures: call remove_unshown_pictures next.
void remove_reports(const std::filesystem::path& dir, const std::string& name);

// Prints the class as a table for a terminal: a line for each submission, a column for each exercise. There
// are no colours, and only ASCII, except in people's names. Long names are cut, so that rows stay apart; with
// `people` the folder's name ends the line.
void print_table(std::ostream& out, const std::vector<SubmissionResult>& results,
                 const NamesForPeople& people = {});

}  // namespace grader::report

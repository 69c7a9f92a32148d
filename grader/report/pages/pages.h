// STAFF ONLY. Declares the HTML pages.
#pragma once

#include <string>
#include <vector>

#include "grader/compare/compare.h"
#include "grader/report/facts/class_facts.h"
#include "grader/result/costs.h"
#include "grader/result/result.h"
#include "grader/result/study.h"
#include "grader/roster/class_list.h"
#include "hair/io/plot/html.h"

namespace grader::inline report {

using hair::Html, hair::html, hair::html_page, hair::Pictures, hair::Scripts;

std::string student_page(
    const SubmissionResult& result,
    const NamesForPeople& people = {});  // writes NAME/report.html, without the staff's texts
std::string staff_page(const SubmissionResult& result, const NamesForPeople& people = {});  // staff/NAME.html

// Writes staff/runs/NAME/H4.html: both motions of a whole run over one another, and its measured pictures.
std::string run_page(const SubmissionResult& result, const ExerciseResult& exercise,
                     const NamesForPeople& people = {});

// Writes the part of the staff's page about an exercise, or all of it if there is no such exercise.
// `staff` is the folder of its pictures and runs, from the page on.
Html staff_part(const SubmissionResult& result, const std::string& exercise, const std::string& staff);

// Writes NAME/study.html for both.
std::string study_page(const SubmissionResult& result, const SubmissionStudy& study,
                       const NamesForPeople& people = {});

std::string class_page(const std::vector<SubmissionResult>& results, const ClassFacts& facts = {},
                       const NamesForPeople& people = {});  // writes index.html

std::string course_page(const CourseTable& course, const std::vector<ClassLine>& lines,
                        const NamesForPeople& people = {});  // writes index.html above several hand-ins

// Writes the folder's name, which commands take, behind a person's name.
Html folder_beside(const std::string& name, const NamesForPeople& people);

// Writes a heading with a count that opens and closes. It is open for few of them; empty for none.
Html folded(const Html& heading, std::size_t count, const Html& content, std::size_t most_open = 0);

// Lists people who are missing, or on no roster; empty if there are none.
Html people_section(const std::vector<ClassLine>& people);

// Lists files; empty if there are none.
Html left_over_section(const std::vector<Accounted>& listed, const NamesForPeople& people = {});

// Lists late people, if there is a due date.
Html late_section(const ClassFacts& facts, const NamesForPeople& people = {});

// Says that the last run was interrupted; otherwise empty.
Html run_section(const std::optional<LastRun>& run);

// These parts of the class's page count people (class_statistics.h).
Html exercises_part(const std::vector<SubmissionResult>& results);
Html distribution_part(const std::vector<SubmissionResult>& results);
Html categories_part(const std::vector<SubmissionResult>& results);
Html sections_part(const std::vector<SubmissionResult>& results,
                   const std::vector<ClassLine>& people);  // empty without sections
// Lists answers of about.txt (about.h), without names; empty if nobody answered.
Html about_section(const std::vector<SubmissionResult>& results);

// This is a script: it lets readers sort tables by columns with data-sort, "text" or "number".
std::string sort_script();

const char* look_of(Status status);  // returns the status as a class of the style sheet
Html badge(Status status);           // writes the status in words, coloured

// Writes the warning of every page with results that were graded without namespaces, or without pictures.
Html stamps(Isolation isolation, bool images);

// Writes costs.html: the time of grading, the most expensive first, compared with the reference. It differs
// from run to run.
std::string costs_page(const ClassCosts& costs, const NamesForPeople& people = {});

// Holds a pair, as the bytes of PNG files. The heat map may be smaller.
struct ShownPair {
  ComparedPair pair;
  std::string reference, test, heat;
};

// Return the names of a pair's full-size files beside the page: "frame-0003-heat.png".
std::string heat_file(const std::string& name);
std::string side_file(const std::string& name);

// Writes a page for TAs with compared pictures, worst first: small ones, and links to files beside it.
std::string comparison_page(const Comparison& comparison, const std::vector<ShownPair>& worst);

// Shows a student's file to staff, with messages at the lines that they are about.
Html source_part(const ExerciseResult& exercise);

}  // namespace grader::report

// STAFF ONLY. The HTML pages.
#pragma once

#include <string>
#include <vector>

#include "grader/report/class_facts.h"
#include "grader/report/course_table.h"
#include "grader/result/result.h"
#include "grader/result/study.h"
#include "hair/io/plot/html.h"

namespace grader::inline report {

using hair::Html, hair::html, hair::html_page, hair::Pictures, hair::Scripts;

std::string student_page(
    const SubmissionResult& result,
    const NamesForPeople& people = {});  // NAME/report.html: contains nothing of the staff's
std::string staff_page(const SubmissionResult& result, const NamesForPeople& people = {});  // staff/NAME.html

// NAME/study.html, for students and staff. `beside_itself` is the reference's study, which shows the noise.
std::string study_page(const SubmissionResult& result, const SubmissionStudy& study,
                       const SubmissionStudy& beside_itself, const NamesForPeople& people = {});

std::string class_page(const std::vector<SubmissionResult>& results, const ClassFacts& facts = {},
                       const NamesForPeople& people = {});  // index.html

std::string course_page(const CourseTable& course, const std::vector<ClassLine>& lines,
                        const NamesForPeople& people = {});  // index.html above several hand-ins

// Behind a person's name: the folder's, which commands take.
Html folder_beside(const std::string& name, const NamesForPeople& people);

// Lists people who are missing, or on no roster; empty if nobody is.
Html people_section(const std::vector<ClassLine>& people);

// Lists files; empty if there are none.
Html left_over_section(const std::vector<Accounted>& listed, const NamesForPeople& people = {});

// Lists those who were late, where there is a date.
Html late_section(const ClassFacts& facts, const NamesForPeople& people = {});

// Says that the last run is not whole; else empty.
Html run_section(const std::optional<LastRun>& run);

// Its parts that count people (class_statistics.h).
Html exercises_part(const std::vector<SubmissionResult>& results);
Html distribution_part(const std::vector<SubmissionResult>& results);
Html categories_part(const std::vector<SubmissionResult>& results);
Html sections_part(const std::vector<SubmissionResult>& results,
                   const std::vector<ClassLine>& people);  // nothing without sections
Html alike_part(const std::vector<SubmissionResult>& results,
                const NamesForPeople& people = {});  // nothing if nobody does

// Answers of about.txt (about.h), without names; nothing if nobody answered.
Html about_section(const std::vector<SubmissionResult>& results);

// Lets a reader sort a table of class "class" by its columns with data-sort, "text" or "number".
Html sort_script();

const char* look_of(Status status);  // the status as a class of the style sheet
Html badge(Status status);           // the status in words, coloured

// The warning of every page with results that were graded without namespaces, or without pictures.
Html stamps(Isolation isolation, bool images);

}  // namespace grader::report

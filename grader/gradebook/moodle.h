// STAFF ONLY. Fills in Moodle's grading worksheet, in its own form.
#pragma once

#include "grader/gradebook/filling.h"

namespace grader::inline gradebook {

// Titles are in the downloader's language: if they are not English, columns are found by form
// (roster/worksheet.h), and `options.column` names the one of grades if that fails. Rows that Moodle locks,
// and grades beyond its maximum, stay unchanged and are reported.
Gradebook fill_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const FillOptions& options);

}  // namespace grader::gradebook

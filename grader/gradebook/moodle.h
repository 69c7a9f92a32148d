// STAFF ONLY. Moodle's grading worksheet, filled in as it was downloaded.
#pragma once

#include "grader/gradebook/filling.h"

namespace grader::inline gradebook {

// Titles are in the language of whoever downloads: where they are not English, columns are found by form
// (roster/worksheet.h), and `options.column` names the one of grades if that fails. Rows that Moodle locks,
// and grades beyond its maximum, are left as they are and said.
Gradebook fill_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const FillOptions& options);

}  // namespace grader::gradebook

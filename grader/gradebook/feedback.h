// STAFF ONLY. Makes archives of feedback for learning systems, with the file names that they need.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "grader/archive/archive_writer.h"
#include "grader/gradebook/filling.h"
#include "grader/text/csv.h"

namespace grader::inline gradebook {

struct Feedback {
  std::vector<ArchiveEntry> entries;
  std::vector<std::string> said{};  // for staff, a line each: who gets none, and why; how it arrives
};

// This is a student's report in its two forms.
struct ReportOfStudent {
  std::string page;  // is HTML that loads nothing
  std::string text;
};
using ReportOf = std::function<ReportOfStudent(const std::string& hand_in)>;

// This is for Canvas's "Re-upload submissions". `files` are the names in the graded download. A file goes back
// under the name of an attachment, and the student sees that name: so its content must fit it: a page, an
// archive with the page, or text.
Feedback feedback_for_canvas(const std::vector<std::string>& files, const std::vector<Grade>& grades,
                             const ReportOf& report);

// This is for Moodle's "Upload multiple feedback files in a zip". The worksheet names the participant of a number:
// a team's number in a download may be another student's.
Feedback feedback_for_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const ReportOf& report);

}  // namespace grader::gradebook

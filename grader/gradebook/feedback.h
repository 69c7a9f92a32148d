// STAFF ONLY. Archives of feedback that learning systems hand out to students, by the names of the files in
// them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "grader/archive/archive_writer.h"
#include "grader/gradebook/grade.h"
#include "grader/text/csv.h"

namespace grader::inline gradebook {

struct Feedback {
  std::vector<ArchiveEntry> entries;
  std::vector<std::string> said{};  // for staff, a line each: who gets none, and why; how it arrives
};

// A student's report in the two forms that there are.
struct ReportOfStudent {
  std::string page;  // HTML that loads nothing
  std::string text;
};
using ReportOf = std::function<ReportOfStudent(const std::string& hand_in)>;

// For Canvas's "Re-upload submissions". `files` are the names in the download that was graded. A file goes
// back under the name of an attachment, and the student sees that name: so its content is what opens under
// it, a page, an archive with the page, or text.
Feedback feedback_for_canvas(const std::vector<std::string>& files, const std::vector<Grade>& grades,
                             const ReportOf& report);

// For Moodle's "Upload multiple feedback files in a zip". The worksheet says whose a participant's number is:
// a team's number in a download may be another student's.
Feedback feedback_for_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const ReportOf& report);

}  // namespace grader::gradebook

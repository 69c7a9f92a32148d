// STAFF ONLY. Writes the files of a folder of grades.
#include "grader/tool/class_files.h"

#include <utility>

#include "grader/course/input.h"
#include "grader/report/costs_page.h"
#include "grader/report/picture_files.h"
#include "grader/report/report.h"

namespace grader {

void write_student_files(const std::filesystem::path& folder, const Recorded& one) {
  if (one.study)
    write_study(folder, one.result, one.study->own, one.study->beside_itself);
  else
    remove_study(folder, one.result);
  write_submission_reports(folder, one.result);
}

std::vector<SubmissionResult> write_class_files(const std::filesystem::path& folder, Record& record,
                                                const std::set<std::string>& written) {
  std::vector<SubmissionResult> results;
  ClassCosts costs = record.costs();
  for (const std::string& name : record.names()) {
    std::optional<Recorded> one = record.find_decided(name);
    if (!one) continue;  // somebody has been forgotten just now
    if (!written.contains(name)) write_student_files(folder, *one);
    if (!one->result.ended_by_the_clock.empty())
      costs.ended_by_the_clock[name] = one->result.ended_by_the_clock;
    results.push_back(std::move(one->result));
  }
  write_class_reports(folder, results, lines_of(record.class_list(), record.hand_ins()));
  remove_unshown_pictures(folder);
  write_file(folder / "timing.json", to_json(costs));
  write_file(folder / "costs.html", costs_page(costs_table(costs)));
  return results;
}

}  // namespace grader

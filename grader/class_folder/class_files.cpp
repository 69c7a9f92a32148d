// STAFF ONLY. Writes the files of a folder of grades.
#include "grader/class_folder/class_files.h"

#include <utility>

#include "grader/class_folder/blind.h"
#include "grader/class_folder/changes_page.h"
#include "grader/class_folder/course_files.h"
#include "grader/course/input.h"
#include "grader/intake/left_over.h"
#include "grader/report/facts/picture_files.h"
#include "grader/report/pages/costs_page.h"
#include "grader/report/report.h"

namespace grader::inline class_folder {

void write_student_files(const std::filesystem::path& folder, const Recorded& one,
                         const NamesForPeople& people) {
  if (one.study)
    write_study(folder, one.result, one.study->own, one.study->beside_itself, people);
  else
    remove_study(folder, one.result);
  write_submission_reports(folder, one.result, people);
}

namespace {

std::vector<SubmissionResult> write_files_of_hand_in(Record& record, const std::set<std::string>& written) {
  const std::filesystem::path folder = record.pages();
  std::vector<SubmissionResult> results;
  ClassCosts costs = record.costs();
  const NamesForPeople people = record.names_for_people();
  const std::optional<HiddenNames> hidden = record.hidden_names();
  std::map<std::string, Lateness> late;
  for (const std::string& name : record.names()) {
    std::optional<Recorded> one = record.find_decided(name);
    if (!one) continue;  // this student has just been forgotten
    if (hidden) hide(*hidden, one->result);
    if (!written.contains(name)) write_student_files(folder, *one, people);
    if (!one->result.ended_by_the_clock.empty())
      costs.ended_by_the_clock[name] = one->result.ended_by_the_clock;
    late[name] = one->late;
    results.push_back(std::move(one->result));
  }
  const std::vector<ClassLine> lines = lines_of(record.class_list(), record.hand_ins());
  const std::vector<Accounted> listed = record.listed();
  write_class_reports(folder, results,
                      {hidden ? blind(lines) : lines, listed, costs.last_run, record.rules().due, late},
                      people);
  write_changes_page(folder, class_changes(record), people);
  write_file(folder / kLeftOver, left_over_json(listed));
  remove_unshown_pictures(folder);
  write_file(folder / "timing.json", to_json(costs));
  write_file(folder / "costs.html", costs_page(costs_table(costs), people));
  return results;
}

}  // namespace

std::vector<SubmissionResult> write_class_files(const std::filesystem::path& folder, Record& record,
                                                const std::set<std::string>& written) {
  std::vector<SubmissionResult> results = write_files_of_hand_in(record, written);
  if (record.hand_in().empty()) return results;
  // A free day that one hand-in uses is gone for later ones.
  if (record.rules().free_days_in_all > 0)
    for (const std::string& name : record.named_hand_ins())
      if (Record other(folder, name); name != record.hand_in()) write_files_of_hand_in(other, {});
  write_course_files(folder);
  return results;
}

}  // namespace grader::class_folder

// STAFF ONLY. Gathers the totals of all hand-ins of a record.
#include "grader/class_folder/course_files.h"

#include <algorithm>
#include <map>

#include "grader/class_folder/blind.h"
#include "grader/record/points/hand_ins.h"
#include "grader/record/record.h"
#include "grader/report/report.h"

namespace grader::inline class_folder {

void write_course_files(const std::filesystem::path& folder) {
  Record record(folder);
  const std::vector<std::string> names = record.named_hand_ins();
  if (names.empty()) return;
  CourseTable course;
  std::map<std::string, CourseTable::Row> rows;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Record hand_in(folder, names[i]);
    const HandInRules rules = hand_in.rules();
    course.hand_ins.push_back({names[i], folder_of_hand_in(names[i]), rules.extra_credit_share.value(),
                               rules.total_per_cent_at_most / 100});
    for (const auto& [name, total] : hand_in.totals()) {
      CourseTable::Row& row = rows[name];
      row.name = name;
      row.cells.resize(names.size());
      row.cells[i] = {total.points, total.max_points, total.extra_credit};
      course.hand_ins[i].max_points = std::max(course.hand_ins[i].max_points, total.max_points);
    }
  }
  for (auto& [name, row] : rows) course.rows.push_back(std::move(row));
  const std::optional<ClassList> list = record.class_list(Record::Of::course);
  const std::vector<HandIn> hand_ins = record.hand_ins(Record::Of::course);
  const std::vector<ClassLine> lines = lines_of(list, hand_ins);
  if (record.is_blind())
    write_course_reports(folder, course, blind(lines));
  else
    write_course_reports(folder, course, lines, names_for_people(list, hand_ins));
}

}  // namespace grader::class_folder

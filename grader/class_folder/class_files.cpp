// STAFF ONLY. Writes the files of a folder of grades.
#include "grader/class_folder/class_files.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>

#include "grader/class_folder/blind.h"
#include "grader/course/input.h"
#include "grader/intake/submission.h"
#include "grader/record/points/hand_ins.h"
#include "grader/record/record.h"
#include "grader/report/facts/picture_files.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/report/report.h"

namespace grader::inline class_folder {

namespace {

// Does nothing for a record whose hand-in has no name.
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

struct InCategory {
  std::string title;
  std::size_t more = 0, less = 0;
};

std::string shown(const std::optional<double>& points) {
  return points ? shown_points(*points) : "not there";
}

Html table(const char* head, const Html& rows) {
  return html(
      "<div class=\"wide\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      {Html{head}, rows});
}

}  // namespace

std::string shown_change(const PointsChange& change) {
  return shown(change.before) + " -> " + shown(change.after);
}

ClassChanges class_changes(Record& record) {
  ClassChanges all;
  for (const std::string& name : record.names())
    if (std::vector<PointsChange> theirs = changes(record.log(name)); !theirs.empty())
      all.emplace_back(name, std::move(theirs));
  return all;
}

void write_student_files(const std::filesystem::path& folder, const Recorded& one,
                         const NamesForPeople& people) {
  if (one.study)
    write_study(folder, one.result, *one.study, people);
  else
    remove_study(folder, one.result);
  write_submission_reports(folder, one.result, people);
}

std::optional<Recorded> find_shown(Record& record, const std::string& name,
                                   const std::optional<HiddenNames>& hidden) {
  std::optional<Recorded> found = record.find_decided(name);
  if (found && hidden) hide(*hidden, found->result);
  return found;
}

namespace {

// Removes the page if nothing has changed.
void write_changes_page(const std::filesystem::path& folder, const ClassChanges& all,
                        const NamesForPeople& people) {
  const std::filesystem::path file = folder / kChangesPage;
  if (all.empty()) {
    std::filesystem::remove(file);
    return;
  }
  std::map<std::string, InCategory> categories;
  Html students;
  for (const auto& [name, theirs] : all) {
    std::string line;
    for (const PointsChange& one : theirs) {
      InCategory& category = categories[one.place];
      category.title = one.title;
      (one.after.value_or(0) > one.before.value_or(0) ? category.more : category.less) += 1;
      line += (line.empty() ? "" : "; ") + one.place + " " + shown_change(one);
    }
    students += html("<tr><th scope=\"row\"><a href=\"staff/{}.html\">{}</a></th><td>{}</td></tr>\n",
                     {name, shown_name(name, people), line});
  }
  Html rows;
  for (const auto& [place, one] : categories)
    rows += html(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td></tr>\n",
        {place, one.title, one.more, one.less});
  write_file(
      file,
      html_page("What the last grading changed",
                html("<header>\n<h1>What the last grading changed</h1>\n<p class=\"quiet\"><a "
                     "href=\"index.html\">The class</a> &#183; computed points, without people's "
                     "decisions</p>\n</header>\n<main>\n<section>\n<h2>By category</h2>\n{}</section>\n"
                     "<section>\n<h2>By student</h2>\n{}</section>\n</main>\n",
                     {table("<th scope=\"col\">Category</th><th scope=\"col\">Title</th><th "
                            "scope=\"col\" class=\"number\">Have more</th><th scope=\"col\" "
                            "class=\"number\">Have less</th>",
                            rows),
                      table("<th scope=\"col\">Student</th><th scope=\"col\">Changes</th>", students)})));
}

struct ShownClass {
  std::vector<SubmissionResult> results;
  ClassFacts facts;
};

// Passes each result on with its study and costs, before its lateness alone is kept.
ShownClass read_class(Record& record, const std::function<void(const Recorded&)>& each) {
  ShownClass all;
  const std::optional<HiddenNames> hidden = record.hidden_names();
  for (const std::string& name : record.names()) {
    std::optional<Recorded> one = find_shown(record, name, hidden);
    if (!one) continue;  // this student has just been forgotten
    each(*one);
    all.facts.late[name] = one->late;
    if (one->study) all.facts.studies.emplace_back(name, *one->study);
    all.results.push_back(std::move(one->result));
  }
  const std::vector<ClassLine> lines = lines_of(record.class_list(), record.hand_ins());
  all.facts.people = hidden ? blind(lines) : lines;
  all.facts.listed = record.listed();
  all.facts.run = record.costs().last_run;
  all.facts.due = record.rules().due;
  return all;
}

std::vector<SubmissionResult> write_files_of_hand_in(Record& record, const std::set<std::string>& written) {
  const std::filesystem::path folder = record.pages();
  ClassCosts costs = record.costs();
  const NamesForPeople people = record.names_for_people();
  ShownClass all = read_class(record, [&](const Recorded& one) {
    const SubmissionResult& result = one.result;
    if (!written.contains(result.name)) write_student_files(folder, one, people);
    if (!result.ended_by_the_clock.empty()) costs.ended_by_the_clock[result.name] = result.ended_by_the_clock;
  });
  write_class_reports(folder, all.results, all.facts, people);
  write_changes_page(folder, class_changes(record), people);
  write_file(folder / kLeftOver, left_over_json(all.facts.listed));
  remove_unshown_pictures(folder);
  write_file(folder / "timing.json", to_json(costs));
  write_file(folder / "costs.html", costs_page(costs, people));
  return std::move(all.results);
}

}  // namespace

std::string class_page_of(Record& record) {
  const ShownClass all = read_class(record, [](const Recorded&) {});
  return class_page(all.results, all.facts, record.names_for_people());
}

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

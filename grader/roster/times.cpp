// STAFF ONLY. Finds times of hand-ins in a table.
#include "grader/roster/times.h"

#include <algorithm>
#include <chrono>

#include "grader/course/input.h"
#include "grader/roster/worksheet.h"
#include "grader/text/letters.h"
#include "grader/text/time_text.h"

namespace grader::inline roster {
namespace {

// These are: Moodle: Last modified (submission). Gradescope: Submission Time. Classroom:
// submission_timestamp. Canvas's API: submitted_at.
constexpr std::array<const char*, 9> kTitles{"Time",
                                             "Handed in",
                                             "Submitted",
                                             "Submitted at",
                                             "submitted_at",
                                             "Submission time",
                                             "Submission date",
                                             "submission_timestamp",
                                             "Last modified (submission)"};

std::optional<std::size_t> column_by_title(const Csv& table) {
  for (const char* title : kTitles)
    if (const std::size_t column = column_of(table, title); column != kNoColumn) return column;
  return {};
}

std::string not_read_as_time(const Csv& table, const Csv::Row& row, std::size_t column) {
  return place_of(table, row) + ": \"" + legible(composed(row.at(column))) +
         "\" is no time that is read; write one such as 2025-03-04 10:15, or export the table in English";
}

// In Moodle's worksheet of any language, times of hand-ins follow the column "Grade can be changed".
std::optional<std::size_t> column_by_place(const Csv& table) {
  const std::optional<Worksheet> sheet = worksheet_by_form(table);
  if (!sheet || sheet->may_change == kNoColumn) return {};
  const std::size_t column = sheet->may_change + 1;
  const Csv::Row* not_read = nullptr;
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const std::string cell = composed(table.rows[i].at(column));
    if (read_time(cell)) return column;
    if (!not_read && !cell.empty() && cell != "-") not_read = &table.rows[i];
  }
  if (not_read) throw BadInput(not_read_as_time(table, *not_read, column));
  return {};
}

std::size_t column_of_times(const Csv& table) {
  if (const std::optional<std::size_t> column = column_by_title(table)) return *column;
  if (const std::optional<std::size_t> column = column_by_place(table)) return *column;
  std::string titles;
  for (const char* title : kTitles) titles += (titles.empty() ? "\"" : "\", \"") + std::string(title);
  throw BadInput(place_of(table, table.rows.front()) + ": no column has times; give it one of the titles " +
                 titles + "\"");
}

}  // namespace

Times::Times(Csv table)
    : table_(std::move(table)),
      column_(column_of_times(table_)),
      people_(table_),
      found_(people_.people().size()),
      said_(people_.said()) {
  if (!column_by_title(table_))
    said_.push_back(table_.file + ": times are taken from the column \"" +
                    legible(table_.rows.front().at(column_)) + "\", by its place in a grading worksheet");
}

std::string Times::time_of(std::size_t person) {
  found_[person] = true;
  const std::size_t line = people_.people()[person].line;
  const auto row = std::ranges::find(table_.rows, line, &Csv::Row::line);
  const std::string cell = composed(row->at(column_));
  if (cell.empty() || cell == "-" || read_time(cell)) return cell.empty() ? "-" : cell;
  std::string told = not_read_as_time(table_, *row, column_);
  if (std::ranges::count(said_, told) == 0) said_.push_back(std::move(told));
  return "";
}

std::string Times::find(const std::string& hand_in, const Owner& owner, const std::string& system,
                        const Roster* roster) {
  std::string latest;
  std::optional<std::chrono::sys_seconds> latest_moment;
  std::vector<std::string> told;
  for (const std::size_t person : people_.find_all(owner, system, roster, told)) {
    const std::string time = time_of(person);
    const std::optional<TimeText> read = read_time(time);
    if (!read && latest.empty()) latest = time;
    if (!read) continue;
    const std::chrono::sys_seconds moment(read->clock - read->offset.value_or(std::chrono::minutes(0)));
    if (!latest_moment || moment > *latest_moment) {
      latest = time;
      latest_moment = moment;
    }
  }
  for (const std::string& line : told) said_.push_back(hand_in + ": in " + table_.file + ": " + line);
  return latest;
}

std::vector<std::string> Times::said() const {
  std::vector<std::string> lines = said_;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const Person& person = people_.people()[i];
    const auto row = std::ranges::find(table_.rows, person.line, &Csv::Row::line);
    const std::string cell = composed(row->at(column_));
    if (!found_[i] && !cell.empty() && cell != "-")
      lines.push_back(place_of(table_, *row) + ": " +
                      (person.name.empty() ? person.shown_id() : person.name) +
                      " has a time, and no hand-in here");
  }
  return lines;
}

}  // namespace grader::roster

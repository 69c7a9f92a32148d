// STAFF ONLY. Fills in Moodle's worksheet. Its importer skips a bad row silently.
#include "grader/gradebook/filling.h"

#include <algorithm>

#include "grader/course/input.h"
#include "grader/roster/worksheet.h"
#include "grader/text/letters.h"

namespace grader::inline gradebook {
namespace {

constexpr const char* kGradedAt = "Last modified (grade)";

[[noreturn]] void fail(const Csv& table, const std::string& why) {
  throw BadInput(place_of(table, table.rows.front()) + ": " + why);
}

// Finds columns by English titles.
Worksheet columns_by_title(const Csv& table, const std::string& grades) {
  Worksheet sheet{.identifier = column_of(table, "Identifier"),
                  .grade = column_of(table, grades.empty() ? "Grade" : grades),
                  .maximum = column_of(table, "Maximum grade"),
                  .may_change = column_of(table, "Grade can be changed")};
  if (sheet.identifier == kNoColumn)
    fail(table,
         "no title is \"Identifier\", and the table has not the form of a worksheet, which begins with "
         "\"Participant 4711\"; download the grading worksheet of the assignment");
  if (sheet.grade == kNoColumn)
    fail(table, "no title is \"" + composed(grades.empty() ? "Grade" : grades) +
                    "\"; give --column with the title of the grades");
  if (column_of(table, kGradedAt) == kNoColumn)
    fail(table, "no title is \"" + std::string(kGradedAt) +
                    "\", which Moodle's import asks for; download the worksheet again");
  return sheet;
}

std::string titles_of(const std::vector<std::string>& titles) {
  std::string all;
  for (const std::string& title : titles) all += (all.empty() ? "\"" : ", \"") + title + "\"";
  return all;
}

// Finds columns by place and form if titles are in another language, and reports it.
Worksheet columns_by_form(const Csv& table, const Worksheet& sheet, const std::string& grades,
                          std::vector<std::string>& said) {
  const Cells& titles = table.rows.front().cells;
  const auto title = [&](std::size_t column) { return "\"" + composed(titles[column]) + "\""; };
  if (sheet.grade == kNoColumn)
    fail(table,
         (!grades.empty()             ? "no title is \"" + composed(grades) + "\""
          : sheet.like_grades.empty() ? std::string("no column looks like grades with a maximum behind it")
                                      : std::string("several columns look like grades")) +
             "; give --column with " +
             (sheet.like_grades.empty() ? "the title of the grades"
                                        : "one of " + titles_of(sheet.like_grades)));
  std::string taken =
      title(sheet.identifier) + " has the numbers of participants, " + title(sheet.grade) + " the grades";
  if (sheet.maximum != kNoColumn) taken += ", " + title(sheet.maximum) + " the maximum";
  if (sheet.may_change != kNoColumn) taken += ", " + title(sheet.may_change) + " says which are locked";
  said.push_back("not certain: the titles are not English, so columns were found by their cells: " + taken +
                 "; if that is wrong, give --column with the title of the grades");
  if (sheet.may_change == kNoColumn)
    said.emplace_back(
        "not certain: nothing says which grades Moodle has locked; its import passes over these");
  said.emplace_back(
      "Moodle's import knows these titles in their own language alone: upload with Moodle in that language");
  return sheet;
}

}  // namespace

Gradebook fill_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const FillOptions& options) {
  const std::size_t titles = worksheet.rows.front().cells.size();
  std::optional<Worksheet> by_form;
  if (column_of(worksheet, "Identifier") == kNoColumn) by_form = worksheet_by_form(worksheet, options.column);
  std::vector<std::string> notes;
  const Worksheet sheet = by_form ? columns_by_form(worksheet, *by_form, options.column, notes)
                                  : columns_by_title(worksheet, options.column);
  const std::size_t column = sheet.grade, of = sheet.maximum;
  for (const Csv::Row& row : worksheet.rows)  // one such row stops the import of older versions
    if (row.cells.size() != titles)
      throw BadInput(place_of(worksheet, row) + ": has " + std::to_string(row.cells.size()) +
                     " cells, and there are " + std::to_string(titles) +
                     " titles; download the worksheet again");
  const bool comma = of != kNoColumn && std::ranges::any_of(worksheet.rows, [&](const Csv::Row& row) {
                       return number_in(row.cells[of]) && row.cells[of].find(',') != std::string::npos;
                     });
  Filling filling(
      worksheet, grades, options,
      {.system = "Moodle's worksheet",
       .title = worksheet.file + ": the column \"" + composed(worksheet.rows.front().cells[column]) + "\"",
       .comma = comma,
       .beyond_maximum = ", and Moodle would pass over it"});
  for (std::string& note : notes) filling.say(std::move(note));
  std::string csv = csv_line(worksheet.rows.front().cells, worksheet.separator, worksheet.end_of_line);
  for (std::size_t i = 1; i < worksheet.rows.size(); ++i) {
    const Csv::Row& row = worksheet.rows[i];
    Cells cells = row.cells;
    const bool locked = says_no(row.at(sheet.may_change));
    const std::optional<double> maximum = of == kNoColumn ? std::nullopt : number_in(cells[of]);
    if (of != kNoColumn && !maximum && !locked)
      throw BadInput(place_of(worksheet, row) + ": \"" + composed(cells[of]) +
                     "\" is a scale of words; choose points in the assignment's settings, and download "
                     "the worksheet again");
    if (std::optional<std::string> score =
            filling.score(row, cells[column], maximum, locked ? "Moodle has locked it" : ""))
      cells[column] = *score;
    csv += csv_line(cells, worksheet.separator, worksheet.end_of_line);
  }
  if (comma)
    filling.say(
        "not certain: decimals have a comma, as the worksheet's own; Moodle reads them in the language of "
        "whoever uploads");
  if (worksheet.separator != ',')
    filling.say("choose the separator when you upload it; older versions of Moodle take commas alone");
  filling.say(
      "Moodle passes over grades that were changed after the download, and over dates that are not English, "
      "unless \"Update records that have been modified\" is ticked");
  return filling.book(std::move(csv));
}

}  // namespace grader::gradebook

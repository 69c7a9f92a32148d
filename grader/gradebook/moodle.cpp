// STAFF ONLY. Fills in Moodle's worksheet. Its importer passes over a row that it does not like without a word.
#include "grader/gradebook/moodle.h"

#include <algorithm>

#include "grader/course/input.h"
#include "grader/text/letters.h"

namespace grader {
namespace {

std::size_t required(const Csv& table, const std::string& title, const std::string& advice) {
  const std::size_t column = column_of(table, title);
  if (column == kNoColumn)
    throw BadInput(place_of(table, table.rows.front()) + ": no title is \"" + title + "\"; " + advice);
  return column;
}

}  // namespace

Gradebook fill_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const FillOptions& options) {
  const std::string& file = worksheet.file;
  const std::size_t titles = worksheet.rows.front().cells.size();
  required(worksheet, "Identifier",
           "download the grading worksheet of the assignment, with Moodle in English");
  const std::size_t column = required(worksheet, options.column.empty() ? "Grade" : options.column,
                                      "give --column with the title of the grades");
  const std::size_t of = column_of(worksheet, "Maximum grade"),
                    may_change = column_of(worksheet, "Grade can be changed");
  Gradebook book;
  std::vector<std::string> notes;
  if (column_of(worksheet, "Last modified (grade)") == kNoColumn)
    throw BadInput(place_of(worksheet, worksheet.rows.front()) +
                   ": no title is \"Last modified (grade)\", which Moodle's import asks for; download the "
                   "worksheet with Moodle in English");
  for (const Csv::Row& row : worksheet.rows)  // one such row stops the import of older versions
    if (row.cells.size() != titles)
      throw BadInput(place_of(worksheet, row) + ": has " + std::to_string(row.cells.size()) +
                     " cells, and there are " + std::to_string(titles) +
                     " titles; download the worksheet again");
  const bool comma = of != kNoColumn && std::ranges::any_of(worksheet.rows, [&](const Csv::Row& row) {
                       return number_in(row.cells[of]) && row.cells[of].find(',') != std::string::npos;
                     });
  const Filling filling(worksheet, grades, options);
  std::size_t without = 0;
  book.csv = csv_line(worksheet.rows.front().cells, worksheet.separator, worksheet.end_of_line);
  for (std::size_t i = 1; i < worksheet.rows.size(); ++i) {
    const Csv::Row& row = worksheet.rows[i];
    const std::string where = place_of(worksheet, row);
    Cells cells = row.cells;
    const Grade* grade = filling.at(row);
    const auto leave = [&](const std::string& why) {
      notes.push_back(where + ": " + grade->hand_in + "'s grade is not entered: " + why);
    };
    if (!grade) {
      ++without;
    } else if (grade->excused) {
      leave("it is excused, which Moodle's worksheet has no word for");
    } else if (lowered(row.at(may_change)) == "no") {
      leave("Moodle has locked it");
    } else {
      std::optional<double> maximum;
      if (of != kNoColumn) {
        maximum = number_in(cells[of]);
        if (!maximum)
          throw BadInput(where + ": \"" + composed(cells[of]) +
                         "\" is a scale of words; choose points in the assignment's settings, and download "
                         "the worksheet again");
      }
      std::string points = filling.points(
          *grade, maximum, file + ": the column \"" + composed(worksheet.rows.front().cells[column]) + "\"");
      if (maximum && *number_in(points) > *maximum) {
        leave(points + " is more than the maximum of " + composed(cells[of]) +
              ", and Moodle would pass over it");
      } else {
        if (comma) std::ranges::replace(points, '.', ',');
        cells[column] = points;
        ++book.written;
      }
    }
    book.csv += csv_line(cells, worksheet.separator, worksheet.end_of_line);
  }
  book.said = filling.said(without);
  book.said.insert(book.said.end(), notes.begin(), notes.end());
  if (comma)
    book.said.push_back(
        "not certain: decimals have a comma, as the worksheet's own; Moodle reads them in the language of "
        "whoever uploads");
  if (worksheet.separator != ',')
    book.said.emplace_back(
        "choose the separator when you upload it; older versions of Moodle take commas alone");
  book.said.emplace_back(
      "Moodle passes over grades that were changed after the download, and over dates that are not English, "
      "unless \"Update records that have been modified\" is ticked");
  return book;
}

}  // namespace grader

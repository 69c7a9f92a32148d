// STAFF ONLY. Fills in Canvas's gradebook. Its importer takes a column that it does not know for a new
// assignment, and a score over an old one for a change.
#include "grader/gradebook/filling.h"

#include <algorithm>
#include <cctype>

#include "grader/course/input.h"
#include "grader/text/letters.h"

namespace grader::inline gradebook {
namespace {

bool is_row_of_points(const Csv::Row& row) {
  return composed(row.cells[0]) == "Points Possible";
}

// This row says which columns are posted by hand.
bool is_row_of_policies(const Csv::Row& row) {
  return std::ranges::all_of(row.cells, [](const std::string& cell) {
    return cell.empty() || cell == "Manual Posting" || cell == "Muted";
  });
}

// "Lab 3 (8801)" is assignment 8801; "" for other columns.
std::string assignment_in(const std::string& title) {
  const std::size_t open = title.rfind('(');
  if (open == title.npos || title.back() != ')') return "";
  std::string number = title.substr(open + 1, title.size() - open - 2);
  const bool digits = std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; });
  return digits ? number : "";
}

std::size_t last_column_of_people(const Csv& table) {
  const Cells& head = table.rows.front().cells;
  const bool named = head.size() > 3 && (head[0].find("Student") != head[0].npos || head[0] == "LastName");
  const std::size_t id = named && head[0] == "LastName" ? 2 : 1;
  if (!named || head[id] != "ID")
    throw BadInput(place_of(table, table.rows.front()) +
                   ": is no gradebook of Canvas, whose titles begin with Student and ID; in Canvas's "
                   "gradebook choose Export");
  for (std::size_t i = head.size(); i-- > id;)
    if (head[i].find("Section") != head[i].npos && assignment_in(head[i]).empty()) return i;
  throw BadInput(place_of(table, table.rows.front()) +
                 ": no title is Section, as in each export of Canvas; export it there again");
}

std::size_t column_for(const Csv& table, std::size_t behind, const std::string& wanted) {
  const auto is_wanted = [&](std::size_t i) -> std::optional<bool> {
    const std::string& head = table.rows.front().cells[i];
    const std::string number = assignment_in(head);
    if (i <= behind || number.empty()) return {};
    return wanted.empty() || wanted == number || wanted == "(" + number + ")" ||
           composed(wanted) == composed(head) ||
           composed(wanted) == composed(head.substr(0, head.rfind('(')));
  };
  const std::string is = " \"" + composed(wanted) + "\"";
  return wanted_column(
      table, is_wanted,
      "has no assignment's column, as \"Lab 3 (8801)\"; make the assignment in Canvas, and export again",
      "no column is" + is, wanted.empty() ? "has several assignments" : "several columns are" + is);
}

// Copies a row unchanged if the importer takes the separator: a table from a spreadsheet may have tabs.
std::string copied(const Csv& table, const Csv::Row& row, char separator) {
  return separator == table.separator ? std::string(row.bytes) + table.end_of_line
                                      : csv_line(row.cells, separator, table.end_of_line);
}

// The importer reads the last point or comma as the decimal one: "1,234" would become 1.234.
std::string plain_score(const std::string& cell, std::vector<std::string>& said, const std::string& where) {
  const std::string text = composed(cell);
  const bool number = !text.empty() && text.find_first_not_of("0123456789.,-%") == text.npos;
  const std::size_t comma = text.find(','), point = text.find('.');
  if (!number || comma == text.npos) return cell;
  const std::size_t last = text.find_last_of(".,"), decimals = text.size() - last - 1;
  if (point == text.npos && (decimals > 2 || std::ranges::count(text, ',') > 1)) {
    said.push_back(where + ": Canvas would read " + text +
                   " with a decimal comma; the cell is left empty, which Canvas may take for a change");
    return "";
  }
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] != ',' && text[i] != '.')
      plain += text[i];
    else if (i == last)
      plain += '.';
  return plain;
}

}  // namespace

Gradebook fill_canvas(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options) {
  const Csv::Row& head = exported.rows.front();
  const std::size_t people = last_column_of_people(exported),
                    column = column_for(exported, people, options.column);
  const std::string title = "\"" + composed(head.cells[column]) + "\"";
  for (const std::string& cell : head.cells)
    if (starts_formula(cell))
      throw BadInput(place_of(exported, head) + ": a spreadsheet would run the title \"" + composed(cell) +
                     "\" as a formula; rename it in Canvas");
  Filling filling(exported, grades, options,
                  {.system = "Canvas", .title = "the column " + title, .excused = "EX"});
  const char separator = exported.separator == '\t' ? ',' : exported.separator;

  std::vector<std::string> notes;
  std::optional<double> maximum;
  std::string csv = copied(exported, head, separator);
  bool completeness = false;
  for (std::size_t i = 1; i < exported.rows.size(); ++i) {
    const Csv::Row& row = exported.rows[i];
    const std::string where = place_of(exported, row);
    if (row.cells.size() > head.cells.size())
      throw BadInput(where + ": has " + std::to_string(row.cells.size()) + " cells, and there are " +
                     std::to_string(head.cells.size()) + " titles; export the gradebook again");
    if (is_row_of_policies(row) || is_row_of_points(row)) {
      if (is_row_of_points(row)) {
        const std::string points = row.at(column);
        if (points.find("read only") != points.npos)
          throw BadInput(where + ": the column " + title + " is read only; choose another by --column");
        maximum = number_in(points);
      }
      csv += copied(exported, row, separator);
      continue;
    }
    Cells cells = row.cells;
    cells.resize(head.cells.size());
    for (std::size_t j = people + 1; j < cells.size(); ++j)
      if (j != column && !assignment_in(head.cells[j]).empty()) {
        completeness |= lowered(cells[j]) == "complete" || lowered(cells[j]) == "incomplete";
        cells[j] = plain_score(cells[j], notes, where);
      }
    std::string& score = cells[column];
    const bool is_word = score == "EX" || score == "N/A";
    score =
        plain_score(filling.score(row, score, maximum, is_word ? "the column " + title + " has " + score : "")
                        .value_or(score),
                    notes, where);
    csv += csv_line(cells, separator, exported.end_of_line);
  }
  for (std::string& note : notes) filling.say(std::move(note));
  if (!maximum)
    filling.say("the column " + title + " has no points possible, so nothing tells whether the grades fit");
  if (lowered(head.cells[column]).find("final") != std::string::npos)
    filling.say(
        "not certain: Canvas was seen to ignore a column with \"final\" in its title; look at the import, or "
        "rename " +
        title);
  if (completeness)
    filling.say(
        "not certain: Canvas was seen to drop scores beside an assignment that is Complete or Incomplete; "
        "look at the import");
  filling.say(
      "other columns hold the scores of the time of the export: import soon, or Canvas offers to change "
      "later ones back");
  return filling.book(std::move(csv));
}

}  // namespace grader::gradebook

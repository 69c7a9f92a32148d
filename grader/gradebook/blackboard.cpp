// STAFF ONLY. Fills in Blackboard's Grade Center. Its import makes a text column without points of each
// column whose number it does not find.
#include "grader/gradebook/filling.h"

#include <regex>

#include "grader/course/input.h"
#include "grader/text/letters.h"

namespace grader::inline gradebook {
namespace {

// This is "Lab 3 [Total Pts: 10 Score] |664617". Older versions don't say how the column is shown.
struct GradeColumn {
  std::size_t place = 0;
  std::string title, number, points, shown_as;
};

std::optional<GradeColumn> grade_column(const std::string& head, std::size_t place) {
  static const std::regex form(R"((.*?) *\[[^\[]*?: *([^\]\[0-9]*?[0-9][0-9.,]*) *([^\]]*)\] *\|([0-9]+) *)");
  std::smatch part;
  if (!std::regex_match(head, part, form)) return {};
  return GradeColumn{place, composed(part[1].str()), part[4], part[2], part[3]};
}

GradeColumn column_for(const Csv& table, const std::string& wanted) {
  const std::string where = place_of(table, table.rows.front()) + ": ";
  const auto title_of = [&](std::size_t i) { return composed(table.rows.front().cells[i]); };
  const auto is_wanted = [&](std::size_t i) -> std::optional<bool> {
    const std::string title = title_of(i);
    if (const std::optional<GradeColumn> column = grade_column(title, i))
      return wanted.empty() || wanted == column->number || wanted == "|" + column->number ||
             composed(wanted) == column->title || composed(wanted) == title;
    if (!wanted.empty() && composed(wanted) == title)
      throw BadInput(where + "\"" + title +
                     "\" ends with no number such as |664617, without which Blackboard makes a new column of "
                     "text; download the Grade Center again");
    return {};
  };
  const std::size_t place =
      wanted_column(table, is_wanted,
                    "no title is as \"Lab 3 [Total Pts: 10 Score] |664617\"; in Blackboard's Grade Center "
                    "choose Work Offline, "
                    "Download",
                    "no column is \"" + composed(wanted) + "\"", "several columns have grades");
  const GradeColumn column = *grade_column(title_of(place), place);
  if (!number_in(column.points) || (!column.shown_as.empty() && column.shown_as != "Score"))
    throw BadInput(where + "\"" + title_of(place) + "\" is " +
                   (number_in(column.points) ? "no column of scores" : "computed from others") +
                   "; choose one with \"Score\" by --column, or make it one in Blackboard");
  return column;
}

}  // namespace

Gradebook fill_blackboard(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options) {
  const Csv::Row& head = exported.rows.front();
  const std::size_t login = column_of(exported, "Username"),
                    words = column_of(exported, "Feedback to Learner");
  if (login == kNoColumn)
    throw BadInput(
        place_of(exported, head) +
        ": no title is Username, by which Blackboard knows people; in its Grade Center choose Work "
        "Offline, Download");
  const GradeColumn column = column_for(exported, options.column);
  Filling filling(exported, grades, options,
                  {.system = "Blackboard's import", .title = "the column \"" + column.title + "\""});
  std::string csv = std::string(head.bytes) + exported.end_of_line;
  for (std::size_t i = 1; i < exported.rows.size(); ++i) {
    const Csv::Row& row = exported.rows[i];
    Cells cells = row.cells;
    cells.resize(std::max(cells.size(), head.cells.size()));
    std::string& cell = cells[column.place];
    if (composed(cell) == "Needs Grading") cell.clear();
    const std::string state = composed(cell);  // "Needs Grading(7.00)", "In Progress"
    const std::string stays = starts_formula(row.at(login))
                                  ? "a spreadsheet would run the user name as a formula"
                              : state.empty() || number_in(state) ? ""
                                                                  : "it is \"" + legible(state) + "\" there";
    const std::optional<std::string> score = filling.score(row, cell, number_in(column.points), stays);
    if (!score) {
      csv += std::string(row.bytes) + exported.end_of_line;
      continue;
    }
    cell = *score;
    if (words != kNoColumn) cells[words] = filling.feedback(row, cells[words]).value_or(cells[words]);
    csv += csv_line(cells, exported.separator, exported.end_of_line, row.bytes.starts_with('"'));
  }
  filling.say(
      "not certain: this was never tried at a real Blackboard; import this column alone, and look at it");
  filling.say(std::string("it has the form of the download: name it ") +
              (exported.separator == '\t' ? ".xls, and choose the delimiter Tab" : ".csv"));
  return filling.book(encoded(csv, exported.encoding));
}

}  // namespace grader::gradebook

// STAFF ONLY. Writes the class's files of points.
#include "grader/report/gradebook.h"

#include "grader/report/columns.h"
#include "grader/report/text.h"
#include "grader/text/csv.h"

namespace grader {
namespace {

std::string sandbox_cell(Isolation kind) {
  if (kind == Isolation::container) return to_string(kind);
  return kind == Isolation::namespaces ? "yes" : "no";
}

Cells with_person(Cells cells, const ClassLine& person) {
  cells.insert(cells.end(), {person.name, person.id, person.email, person.section, person.note});
  return cells;
}

}  // namespace

std::string grades_csv(const std::vector<SubmissionResult>& results, const std::vector<ClassLine>& people) {
  const std::vector<Column> columns = columns_of(results);
  std::vector<std::string> head{"submission", "total", "of", "sandbox", "pictures"};
  for (const Column& column : columns) {
    head.push_back(column.id);
    head.push_back(column.id + " status");
  }
  head.push_back("note");
  const std::size_t own_columns = head.size();
  if (!people.empty()) head.insert(head.end(), {"name", "id", "e-mail", "section", "roster"});
  std::string text = csv_line(head);
  for (const SubmissionResult& result : results) {
    std::vector<std::string> cells{result.name, shown_points(points(result)),
                                   shown_points(max_points(result)), sandbox_cell(result.isolation),
                                   result.images ? "yes" : "no"};
    for (const Column& column : columns) {
      const ExerciseResult* exercise = find_exercise(result, column.id);
      cells.push_back(exercise ? shown_points(exercise->points) : "");
      cells.push_back(exercise ? to_string(exercise->status) : "");
    }
    cells.push_back(result.note);
    const Cells own = cells;
    bool somebodys = false;
    for (const ClassLine& line : people) {
      if (line.hand_in != result.name) continue;
      text += csv_line(with_person(own, line));
      somebodys = true;
    }
    if (!somebodys) text += csv_line(people.empty() ? own : with_person(own, {}));
  }
  for (const ClassLine& line : people)
    if (line.hand_in.empty()) text += csv_line(with_person(Cells(own_columns), line));
  return text;
}

}  // namespace grader

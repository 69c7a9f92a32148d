// STAFF ONLY. Writes the class's tables of points.
#include "grader/report/points_files.h"

#include "grader/report/facts/columns.h"
#include "grader/report/facts/text.h"
#include "grader/text/csv.h"

namespace grader::inline report {
namespace {

std::string sandbox_cell(Isolation kind) {
  if (kind == Isolation::container) return to_string(kind);
  return kind == Isolation::namespaces ? "yes" : "no";
}

Cells with_person(Cells cells, const ClassLine& person) {
  cells.insert(cells.end(), {person.name, person.id, person.email, person.section, person.note});
  return cells;
}

// Writes a row for each person of a hand-in.
std::string rows_of(const std::string& name, const Cells& own, const std::vector<ClassLine>& people) {
  std::string text;
  for (const ClassLine& line : people)
    if (line.hand_in == name) text += csv_line(with_person(own, line));
  if (text.empty()) return csv_line(people.empty() ? own : with_person(own, {}));
  return text;
}

std::string rows_of_absent(std::size_t own_columns, const std::vector<ClassLine>& people) {
  std::string text;
  for (const ClassLine& line : people)
    if (line.hand_in.empty()) text += csv_line(with_person(Cells(own_columns), line));
  return text;
}

void add_titles_of_people(Cells& head, const std::vector<ClassLine>& people) {
  if (!people.empty()) head.insert(head.end(), {"name", "id", "e-mail", "section", "roster"});
}

}  // namespace

std::string grades_csv(const std::vector<SubmissionResult>& results, const std::vector<ClassLine>& people) {
  const std::vector<Column> columns = columns_of(results);
  std::vector<std::string> head{"submission", "total", "of", "sandbox", "pictures"};
  for (const Column& column : columns) {
    head.push_back(column.id);
    head.push_back(column.id + " status");
  }
  head.insert(head.end(), {"note", "decided"});
  const std::size_t own_columns = head.size();
  add_titles_of_people(head, people);
  std::string text = csv_line(head);
  for (const SubmissionResult& result : results) {
    std::vector<std::string> cells{
        result.name, is_excused_from_all(result) ? "" : shown_points(points(result)),
        shown_points(max_points(result)), sandbox_cell(result.isolation), result.images ? "yes" : "no"};
    for (const Column& column : columns) {
      const ExerciseResult* exercise = find_exercise(result, column.id);
      cells.push_back(exercise && has_points(*exercise) ? shown_points(exercise->points) : "");
      cells.push_back(exercise ? to_string(exercise->status) : "");
    }
    cells.insert(cells.end(), {result.note, decided_in_short(result)});
    text += rows_of(result.name, cells, people);
  }
  return text + rows_of_absent(own_columns, people);
}

std::string course_csv(const CourseTable& course, const std::vector<ClassLine>& people) {
  Cells head{"submission", "total", "of"};
  for (const CourseTable::HandIn& hand_in : course.hand_ins)
    head.insert(head.end(), {hand_in.name, hand_in.name + " of"});
  const std::size_t own_columns = head.size();
  add_titles_of_people(head, people);
  std::string text = csv_line(head);
  for (const CourseTable::Row& row : course.rows) {
    const CourseTable::Cell total = course.total(row);
    Cells cells{row.name, shown_points(total.points), shown_points(total.max_points)};
    for (const std::optional<CourseTable::Cell>& cell : row.cells)
      cells.insert(cells.end(),
                   {cell ? shown_points(cell->points) : "", cell ? shown_points(cell->max_points) : ""});
    text += rows_of(row.name, cells, people);
  }
  return text + rows_of_absent(own_columns, people);
}

}  // namespace grader::report

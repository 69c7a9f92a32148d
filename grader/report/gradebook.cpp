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

}  // namespace

std::string grades_csv(const std::vector<SubmissionResult>& results) {
  const std::vector<Column> columns = columns_of(results);
  std::vector<std::string> head{"submission", "total", "of", "sandbox", "pictures"};
  for (const Column& column : columns) {
    head.push_back(column.id);
    head.push_back(column.id + " status");
  }
  head.push_back("note");
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
    text += csv_line(cells);
  }
  return text;
}

}  // namespace grader

// STAFF ONLY. Writes the class's files of points.
#include "grader/report/gradebook.h"

#include "grader/report/columns.h"
#include "grader/report/text.h"
#include "hair/io/plot/readable.h"

namespace grader {
namespace {

std::string cell(const std::string& bytes) {
  std::string text = hair::valid_utf8(bytes);
  if (!text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos) {
    text.insert(text.begin(), '\'');
  }
  if (text.find_first_of("\",\r\n\t") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + cell(cells[i]);
  return text + "\r\n";
}

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
  std::string text = line(head);
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
    text += line(cells);
  }
  return text;
}

}  // namespace grader

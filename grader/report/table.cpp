// STAFF ONLY.
#include <algorithm>
#include <ostream>
#include <string_view>

#include "grader/course/printable.h"
#include "grader/report/columns.h"
#include "grader/report/report.h"
#include "grader/report/text.h"

namespace grader {
namespace {

constexpr std::size_t longest_name = 32;
using Cells = std::vector<std::string>;

// A word each: eight exercises must stand side by side.
std::string_view word(Status status) {
  switch (status) {
    case Status::passed:
      return "passed";
    case Status::partly:
      return "partly";
    case Status::wrong:
      return "wrong";
    case Status::not_implemented:
      return "stub";
    case Status::missing:
      return "missing";
    case Status::does_not_compile:
      return "compile";
    case Status::crashed:
      return "crash";
    case Status::timed_out:
      return "timeout";
    case Status::out_of_memory:
      return "memory";
    case Status::broke_rules:
      return "rules";
  }
  return "";
}

std::string of(double points, double max_points) {
  return shown_points(points) + "/" + shown_points(max_points);
}

Cells row_of(const SubmissionResult& result, const std::vector<Column>& columns) {
  Cells row{printable(result.name, longest_name)};
  for (const Column& column : columns) {
    const ExerciseResult* exercise = find_exercise(result, column.id);
    row.push_back(exercise ? of(exercise->points, exercise->max_points) : "-");
    row.push_back(exercise ? std::string(word(exercise->status)) : "");
  }
  row.push_back(of(points(result), max_points(result)));
  return row;
}

// Numbers to the right, words to the left.
void print_row(std::ostream& out, const Cells& row, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool number = i % 2 == 1;
    const std::string space(widths[i] - row[i].size(), ' ');
    line += (i == 0 ? "" : number ? "   " : " ") + (number ? space + row[i] : row[i] + space);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  out << line << '\n';
}

}  // namespace

void print_table(std::ostream& out, const std::vector<SubmissionResult>& results) {
  const std::vector<Column> columns = columns_of(results);
  Cells head{"submission"};
  for (const Column& column : columns) {
    head.push_back(printable(column.id));
    head.emplace_back();
  }
  head.push_back("total");
  std::vector<Cells> rows{head};
  double sum = 0;
  for (const SubmissionResult& result : results) {
    rows.push_back(row_of(result, columns));
    sum += points(result);
  }
  std::vector<std::size_t> widths(head.size());
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const Cells& row : rows) print_row(out, row, widths);
  if (!results.empty()) {
    out << results.size() << (results.size() == 1 ? " submission" : " submissions") << ", mean "
        << shown_points(sum / static_cast<double>(results.size())) << '\n';
  }
  if (!all_isolated(results)) out << "GRADED WITHOUT A SANDBOX\n";
}

}  // namespace grader

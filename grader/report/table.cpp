// STAFF ONLY. Prints the class's table on a terminal.
#include <algorithm>
#include <cctype>
#include <map>
#include <ostream>
#include <set>
#include <string_view>

#include "grader/course/input.h"
#include "grader/report/facts/class_statistics.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/text.h"
#include "grader/report/report.h"
#include "grader/text/letters.h"

namespace grader::inline report {
namespace {

// Fourteen exercises stand side by side in 112 columns.
constexpr std::size_t kLongestName = 20;
constexpr std::string_view kCut = "...";
using Cells = std::vector<std::string>;

std::string cut(const std::string& name, std::size_t longest) {
  if (terminal_columns(name) <= longest) return name;
  return first_columns(name, longest - kCut.size()) + std::string(kCut);
}

// Cuts long names, but never so that two different names become equal.
std::vector<std::string> names_of(const std::vector<SubmissionResult>& results,
                                  const NamesForPeople& people) {
  constexpr std::size_t kMostBytes = 1000;
  std::vector<std::string> whole;
  std::size_t longest = kLongestName, longest_of_all = 0;
  for (const SubmissionResult& result : results) {
    whole.push_back(people.contains(result.name) ? legible(people.at(result.name), kMostBytes)
                                                 : printable(result.name));
    longest_of_all = std::max(longest_of_all, terminal_columns(whole.back()));
  }
  const std::size_t apart = std::set<std::string>(whole.begin(), whole.end()).size();
  for (;; ++longest) {
    std::vector<std::string> names;
    for (const std::string& name : whole) names.push_back(cut(name, longest));
    const std::set<std::string> different(names.begin(), names.end());
    if (different.size() == apart || longest >= longest_of_all) return names;
  }
}

Cells ids(const std::vector<Column>& columns) {
  Cells row{"submission"};
  for (const Column& column : columns) row.push_back(printable(column.id));
  row.emplace_back("total");
  return row;
}

Cells reachable(const std::vector<Column>& columns, const std::vector<SubmissionResult>& results) {
  Cells row{"of"};
  for (const Column& column : columns)
    row.push_back((column.extra_credit ? "+" : "") + shown_points(column.max_points));
  double most = 0;
  for (const SubmissionResult& result : results) most = std::max(most, max_points(result));
  row.push_back(most > 0 ? shown_points(most) : "extra");
  return row;
}

Cells row_of(const std::string& name, const SubmissionResult& result, const std::vector<Column>& columns) {
  Cells row{name};
  for (const Column& column : columns) {
    const ExerciseResult* exercise = find_exercise(result, column.id);
    row.push_back(exercise ? in_short(*exercise) : "");
  }
  row.push_back(is_excused_from_all(result) ? "exc" : short_points(points(result)));
  return row;
}

Cells means(const std::vector<SubmissionResult>& results) {
  const std::vector<double> totals = totals_of(results);
  Cells row{"mean of " + std::to_string(totals.size())};
  for (const ExerciseStatistics& one : exercise_statistics(results))
    row.push_back(one.points.empty() ? "" : short_points(mean(one.points)));
  row.push_back(short_points(mean(totals)));
  return row;
}

void print_row(std::ostream& out, const Cells& row, const std::vector<std::size_t>& widths) {
  std::string line = row[0] + std::string(widths[0] - terminal_columns(row[0]), ' ');
  for (std::size_t i = 1; i < widths.size(); ++i)
    line += std::string(2 + widths[i] - row[i].size(), ' ') + row[i];
  for (std::size_t i = widths.size(); i < row.size(); ++i) line += "  " + row[i];  // however long
  out << line << '\n';
}

}  // namespace

void print_table(std::ostream& out, const std::vector<SubmissionResult>& results,
                 const NamesForPeople& people) {
  if (results.empty()) return;
  const std::vector<Column> columns = columns_of(results);
  std::vector<Cells> rows{ids(columns), reachable(columns, results)};
  const std::vector<std::string> names = names_of(results, people);
  const bool with_people = std::ranges::any_of(
      results, [&](const SubmissionResult& result) { return people.contains(result.name); });
  if (with_people) rows.front().emplace_back("folder");
  for (std::size_t i = 0; i < results.size(); ++i) {
    rows.push_back(row_of(names[i], results[i], columns));
    if (with_people) rows.back().push_back(printable(results[i].name));
    if (const std::string decided = decided_in_short(results[i]); !decided.empty())
      rows.back().push_back("(" + decided + ")");
  }
  rows.push_back(means(results));

  std::vector<std::size_t> widths(columns.size() + 2);
  for (const Cells& row : rows)
    for (std::size_t i = 0; i < widths.size(); ++i)
      widths[i] = std::max(widths[i], i == 0 ? terminal_columns(row[i]) : row[i].size());
  for (const Cells& row : rows) print_row(out, row, widths);
  const auto explain = [&](char mark, const char* meaning) {
    if (std::ranges::any_of(rows, [&](const Cells& row) {
          return std::any_of(row.begin() + 1, row.begin() + static_cast<std::ptrdiff_t>(widths.size()),
                             [&](const std::string& cell) { return cell.ends_with(mark); });
        }))
      out << mark << ' ' << meaning << '\n';
  };
  explain('!', "points from before or after a crash or a limit");
  explain('*', "a person set points (hairgrade log)");
  for (const SubmissionResult& result : results)
    if (!result.ended_by_the_clock.empty())
      out << "NOT FINAL, ended by the clock: "
          << (people.contains(result.name) ? called(result.name, people) : printable(result.name)) << ": "
          << in_a_row(result.ended_by_the_clock) << '\n';
  std::map<std::string, std::size_t> to_come;
  for (const SubmissionResult& result : results)
    if (const std::string missing = not_given_yet(result); !missing.empty()) ++to_come[missing];
  for (const auto& [missing, count] : to_come)
    out << "NOT FINAL, " << count << " of " << results.size() << ": " << printable(missing) << '\n';
  std::string said = said_of(least_isolation(results));
  std::ranges::transform(said, said.begin(), [](unsigned char c) { return std::toupper(c); });
  if (!said.empty()) out << said << "\n";
  if (!all_with_images(results)) out << "GRADED WITHOUT PICTURES\n";
}

}  // namespace grader::report

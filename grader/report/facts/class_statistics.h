// STAFF ONLY. Counts a class's results by exercise and category. Each person counts once. A person who is
// excused from an exercise counts neither there nor in totals.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grader/report/facts/columns.h"
#include "grader/result/result.h"
#include "grader/roster/class_list.h"

namespace grader::inline report {

// Counts people by their share of the points, in tenths; extra credit beyond all points counts in the last.
using Tenths = std::array<std::size_t, 10>;

struct ExerciseStatistics {
  Column column;
  std::vector<double> points;  // are those of each person whom it was graded for
  std::size_t passed = 0;
  Tenths tenths = {};
};

struct CategoryStatistics {
  std::string number, name;  // "H2.3"
  double points = 0, max_points = 0;
  std::size_t passed = 0, ran = 0;  // count people; `ran`: their code ran
  // The discrimination index (Kelley 1939), from -1 to 1: the share of the strongest 27 % of the class (by
  // all points) who pass, less that of the weakest 27 %. Nothing for fewer than ten people. Near 0 a category
  // does not separate strong from weak students; below 0 it is worth a look itself.
  std::optional<double> discrimination = {};

  double share() const { return max_points > 0 ? points / max_points : 1; }
};

// Describes a section of the roster. Each person counts once, with the best of their hand-ins; quartiles are
// those of people who handed in.
struct SectionStatistics {
  std::string name;  // "" for people without a section
  std::size_t people = 0, handed_in = 0;
  double first_quartile = 0, median = 0, third_quartile = 0;
};

double mean(const std::vector<double>& values);  // is 0 for no values
std::vector<double> totals_of(const std::vector<SubmissionResult>& results);
Tenths tenths_of_totals(const std::vector<SubmissionResult>& results);
std::vector<ExerciseStatistics> exercise_statistics(const std::vector<SubmissionResult>& results);
std::vector<CategoryStatistics> category_statistics(
    const std::vector<SubmissionResult>& results);  // hardest first
// Sorts by name, "2" before "10". Returns nothing if nobody has a section.
std::vector<SectionStatistics> section_statistics(const std::vector<SubmissionResult>& results,
                                                  const std::vector<ClassLine>& people);
// Returns the value below which `share` of them are, interpolated between two values; 0 for no values.
double quantile(std::vector<double> values, double share);

}  // namespace grader::report

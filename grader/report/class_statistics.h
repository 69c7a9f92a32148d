// STAFF ONLY. What a class's results say about its exercises and categories. Each person counts once.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grader/report/columns.h"
#include "grader/result/result.h"
#include "grader/roster/class_list.h"

namespace grader::inline report {

// People by their share of the points, in tenths; extra credit beyond all points counts in the last.
using Tenths = std::array<std::size_t, 10>;

struct ExerciseStatistics {
  Column column;
  std::vector<double> points;  // of each person who was graded in it
  std::size_t passed = 0;
  Tenths tenths = {};
};

struct CategoryStatistics {
  std::string number, name;  // "H2.3"
  double points = 0, max_points = 0;
  std::size_t passed = 0, ran = 0;  // people whose code ran
  // How much oftener the strongest 27 % of the class (by all points) pass than the weakest 27 %, from -1 to
  // 1: the discrimination index (Kelley 1939). Nothing for fewer than ten people. Near 0 a category does not
  // tell strong from weak students; below 0 it is worth a look itself.
  std::optional<double> discrimination = {};

  double share() const { return max_points > 0 ? points / max_points : 1; }
};

// People who lose the same categories of an exercise, two at least: they have one misunderstanding, or one
// source.
struct FailAlike {
  std::string exercise;
  std::vector<std::string> categories, people;
};

// A section of the roster. Each person counts once, with the best of their hand-ins; quartiles are of those
// who handed in.
struct SectionStatistics {
  std::string name;  // "" for people without one
  std::size_t people = 0, handed_in = 0;
  double first_quartile = 0, median = 0, third_quartile = 0;
};

double mean(const std::vector<double>& values);  // 0 of none
Tenths tenths_of_totals(const std::vector<SubmissionResult>& results);
std::vector<ExerciseStatistics> exercise_statistics(const std::vector<SubmissionResult>& results);
std::vector<CategoryStatistics> category_statistics(
    const std::vector<SubmissionResult>& results);  // hardest first
// By name, "2" before "10". Nothing if nobody has a section.
std::vector<SectionStatistics> section_statistics(const std::vector<SubmissionResult>& results,
                                                  const std::vector<ClassLine>& people);
// The value below which `share` of them are, between two of them in proportion; 0 of none.
double quantile(std::vector<double> values, double share);
std::vector<FailAlike> who_fail_alike(
    const std::vector<SubmissionResult>& results);  // three people and more; most first

}  // namespace grader::report

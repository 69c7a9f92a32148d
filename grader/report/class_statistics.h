// STAFF ONLY. What a class's results say about its exercises and categories. Each person counts once.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grader/report/columns.h"
#include "grader/result/result.h"

namespace grader {

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
  // How much oftener the strongest 27 % of the class (by all points) pass than the weakest 27 %, from -1 to 1: the discrimination
  // index (Kelley 1939). Nothing for fewer than ten people. Near 0 a category does not tell strong from weak students; below 0 it
  // is worth a look itself.
  std::optional<double> discrimination = {};

  double share() const { return max_points > 0 ? points / max_points : 1; }
};

// People who lose the same categories of an exercise, two at least: they have one misunderstanding, or one source.
struct FailAlike {
  std::string exercise;
  std::vector<std::string> categories, people;
};

double mean(const std::vector<double>& values);  // 0 of none
Tenths tenths_of_totals(const std::vector<SubmissionResult>& results);
std::vector<ExerciseStatistics> exercise_statistics(const std::vector<SubmissionResult>& results);
std::vector<CategoryStatistics> category_statistics(
    const std::vector<SubmissionResult>& results);  // hardest first
std::vector<FailAlike> who_fail_alike(
    const std::vector<SubmissionResult>& results);  // three people and more; most first

}  // namespace grader

// STAFF ONLY. Counts people.
#include "grader/report/facts/class_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace grader::inline report {
namespace {

constexpr std::size_t kFewest = 10;  // fewer people have no strong and weak ones
constexpr double kEnds = 0.27;       // is a share of the class

using Results = std::vector<SubmissionResult>;

std::size_t tenth(double points, double of) {
  return static_cast<std::size_t>(std::clamp(of > 0 ? 10 * points / of : 0, 0.0, 9.0));
}

std::string number(const ExerciseResult& exercise, std::size_t i) {
  return exercise.id + "." + std::to_string(i + 1);
}

bool passes(const SubmissionResult& result, const std::string& exercise, std::size_t i) {
  const ExerciseResult* found = find_exercise(result, exercise);
  return found && i < found->cases.size() && found->cases[i].status == Status::passed;
}

// Sorts from the strongest to the weakest. Equal ones stay in the order of their names.
std::vector<const SubmissionResult*> by_points(const Results& results) {
  std::vector<const SubmissionResult*> people;
  for (const SubmissionResult& result : results)
    if (!is_excused(result)) people.push_back(&result);
  std::stable_sort(people.begin(), people.end(),
                   [](const auto* a, const auto* b) { return points(*a) > points(*b); });
  return people;
}

}  // namespace

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

std::vector<double> totals_of(const Results& results) {
  std::vector<double> totals;
  for (const SubmissionResult& result : results)
    if (!is_excused(result)) totals.push_back(points(result));
  return totals;
}

Tenths tenths_of_totals(const Results& results) {
  Tenths tenths{};
  for (const SubmissionResult& result : results)
    if (!is_excused(result)) ++tenths[tenth(points(result), max_points(result))];
  return tenths;
}

std::vector<ExerciseStatistics> exercise_statistics(const Results& results) {
  std::vector<ExerciseStatistics> all;
  for (const Column& column : columns_of(results)) {
    ExerciseStatistics one{column, {}};
    for (const SubmissionResult& result : results) {
      const ExerciseResult* exercise = find_exercise(result, column.id);
      if (!exercise || !has_points(*exercise)) continue;
      one.points.push_back(exercise->points);
      one.passed += exercise->status == Status::passed;
      ++one.tenths[tenth(exercise->points, column.max_points)];
    }
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<CategoryStatistics> category_statistics(const Results& results) {
  std::map<std::pair<std::string, std::size_t>, CategoryStatistics> found;
  for (const SubmissionResult& result : results)
    for (const ExerciseResult& exercise : result.exercises)
      for (std::size_t i = 0; i < exercise.cases.size() && exercise.status != Status::excused; ++i) {
        const CaseResult& one = exercise.cases[i];
        CategoryStatistics& category = found[{exercise.id, i}];
        category.number = number(exercise, i);
        category.name = one.name;
        category.points += one.points;
        category.max_points += one.max_points;
        category.passed += one.status == Status::passed;
        ++category.ran;
      }

  const std::vector<const SubmissionResult*> people = by_points(results);
  const auto ends = static_cast<std::size_t>(std::lround(kEnds * static_cast<double>(people.size())));
  std::vector<CategoryStatistics> categories;
  for (auto& [key, category] : found) {
    if (people.size() >= kFewest) {
      double more = 0;
      for (std::size_t i = 0; i < ends; ++i)
        more += passes(*people[i], key.first, key.second) -
                passes(*people[people.size() - 1 - i], key.first, key.second);
      category.discrimination = more / static_cast<double>(ends);
    }
    categories.push_back(std::move(category));
  }
  std::stable_sort(categories.begin(), categories.end(),
                   [](const auto& a, const auto& b) { return a.share() < b.share(); });
  return categories;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double above = values[std::min(below + 1, values.size() - 1)];
  return std::lerp(values[below], above, place - static_cast<double>(below));
}

std::vector<SectionStatistics> section_statistics(const Results& results,
                                                  const std::vector<ClassLine>& people) {
  if (std::ranges::all_of(people, [](const ClassLine& line) { return line.section.empty(); })) return {};
  std::map<std::string, double> points_of;  // NaN for people who are excused
  for (const SubmissionResult& result : results)
    points_of[result.name] = is_excused(result) ? NAN : points(result);
  const auto by_number = [](const std::string& a, const std::string& b) {
    return strverscmp(a.c_str(), b.c_str()) < 0;
  };
  using IdAndName = std::pair<std::string, std::string>;
  std::map<std::string, std::map<IdAndName, std::optional<double>>, decltype(by_number)> sections(by_number);
  for (const ClassLine& line : people) {
    std::optional<double>& best = sections[line.section][{line.id, line.name}];
    if (const auto found = points_of.find(line.hand_in); found != points_of.end())
      best = std::fmax(best.value_or(found->second), found->second);
  }
  std::vector<SectionStatistics> all;
  for (const auto& [name, members] : sections) {
    std::vector<double> reached;
    std::size_t handed_in = 0;
    for (const auto& [person, best] : members) {
      handed_in += best.has_value();
      if (best && !std::isnan(*best)) reached.push_back(*best);
    }
    all.push_back({name, members.size(), handed_in, quantile(reached, 0.25), quantile(reached, 0.5),
                   quantile(reached, 0.75)});
  }
  return all;
}

}  // namespace grader::report

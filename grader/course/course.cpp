// STAFF ONLY. Reads a course file.
#include "grader/course/course.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "grader/course/input.h"

namespace grader::inline course {
namespace {

void read_budget(Budget& budget, const JsonValue& json) {
  constexpr double kLeast = 1, kMost = 1e9;
  std::vector<std::string_view> known;
  for (const BudgetField& field : budget_fields()) known.emplace_back(field.key);
  json.check_keys(std::span<const std::string_view>(), known);
  for (const BudgetField& field : budget_fields())
    if (json.has(field.key)) budget.*field.value = json[field.key].number(kLeast, kMost);
}

}  // namespace

bool Course::asks_for(const Exercise& exercise) const {
  const bool in_it = of_hand_in.empty() || std::ranges::count(of_hand_in, exercise.id) > 0;
  return in_it && is_asked_for(exercise.role);
}

Course read_course(const std::filesystem::path& exercises_json,
                   const std::optional<std::filesystem::path>& course_json) {
  Course course{hair::read_course(exercises_json, course_json)};
  if (course_json) {
    const nlohmann::json changes = read_json(*course_json);
    const JsonValue json(changes, *course_json);
    if (json.has("budget")) read_budget(course.budget, json["budget"]);
    if (json.has("partial")) course.partial = json["partial"].boolean();
  }
  return course;
}

}  // namespace grader::course

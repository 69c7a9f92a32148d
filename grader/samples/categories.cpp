// STAFF ONLY. Reads the categories of exercises.
#include "grader/samples/categories.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"

namespace grader::inline samples {

SampleCategories read_categories(const std::filesystem::path& project, const Course& course) {
  SampleCategories all;
  for (const Exercise& exercise : course.exercises) {
    const std::filesystem::path file = project / "handout" / exercise.folder / "categories.json";
    const nlohmann::json document = read_json(file);
    for (const JsonValue& json : JsonValue(document, file).items()) {
      json.check_keys({"id", "title", "points", "asks"}, {"functions", "rows"});
      all[exercise.id].push_back({json["id"].text(), json["title"].text(), json["points"].number(0, 1000)});
    }
  }
  return all;
}

double points_without(const std::vector<SampleCategory>& categories, const std::vector<std::string>& failed) {
  double points = 0;
  for (const SampleCategory& category : categories)
    if (std::ranges::find(failed, category.title) == failed.end()) points += category.points;
  return points;
}

}  // namespace grader::samples

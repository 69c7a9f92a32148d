// STAFF ONLY. Reads the suites' table of categories.
#include "grader/samples/categories.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"

namespace grader {

SampleCategories read_categories(const std::filesystem::path& file) {
  const nlohmann::json document = read_json(file);
  const JsonValue top(document, file);
  SampleCategories all;
  for (const std::string& exercise : top.keys())
    for (const JsonValue& json : top[exercise].items()) {
      json.check_keys({"name", "title", "points"});
      all[exercise].push_back({json["name"].text(), json["title"].text(), json["points"].number(0, 1000)});
    }
  return all;
}

double points_without(const std::vector<SampleCategory>& categories, const std::vector<std::string>& failed) {
  double points = 0;
  for (const SampleCategory& category : categories)
    if (std::ranges::find(failed, category.title) == failed.end()) points += category.points;
  return points;
}

}  // namespace grader

// STAFF ONLY. The categories by which exercises are graded, as the hidden suites list them at build time (grader/suite/list_categories.cpp):
//
//   {"H2": [{"name": "Energy", "title": "The energy", "points": 2}, ...], ...}
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace grader {

struct SampleCategory {
  std::string name, title;  // "Energy", and for students "The energy"
  double points = 0;
};

using SampleCategories = std::map<std::string, std::vector<SampleCategory>>;  // by exercise

// Throws BadInput with the file and the JSON path.
SampleCategories read_categories(const std::filesystem::path& file);

// Of an exercise whose categories of these titles fail.
double points_without(const std::vector<SampleCategory>& categories, const std::vector<std::string>& failed);

}  // namespace grader

// STAFF ONLY. The categories by which exercises are graded, as each exercise's categories.json declares them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/course/course.h"

namespace grader::inline samples {

struct SampleCategory {
  std::string name, title;  // "Energy", and for students "The energy"
  double points = 0;
};

using SampleCategories = std::map<std::string, std::vector<SampleCategory>>;  // by exercise

// Reads the categories of all exercises of PROJECT/handout. Throws BadInput with the file and the JSON path.
SampleCategories read_categories(const std::filesystem::path& project, const Course& course);

// Returns the points of an exercise if the categories with these titles fail.
double points_without(const std::vector<SampleCategory>& categories, const std::vector<std::string>& failed);

}  // namespace grader::samples

// STAFF ONLY. The grades of a record, as they go to learning systems.
#pragma once

#include <filesystem>
#include <vector>

#include "grader/gradebook/grade.h"

namespace grader {

// Throws BadInput for a folder without a record, or with one that has no grades.
std::vector<Grade> recorded_grades(const std::filesystem::path& folder);

}  // namespace grader

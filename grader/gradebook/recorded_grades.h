// STAFF ONLY. The grades of a record, for learning systems.
#pragma once

#include <filesystem>
#include <vector>

#include "grader/gradebook/grade.h"
#include "grader/record/record.h"

namespace grader::inline gradebook {

// Returns the grades of the record's hand-in. Throws BadInput if there are none; `folder` is for the message.
std::vector<Grade> recorded_grades(Record& record, const std::filesystem::path& folder);

}  // namespace grader::gradebook

// STAFF ONLY. The samples as tables, for people: those of the class by group, attacks by place.
#pragma once

#include <string>
#include <vector>

#include "grader/samples/sample.h"

namespace grader::inline samples {

// Markdown. "gets" says which exercises don't pass, of those that have a line, and the points that are left,
// if any.
std::string table_of(const std::vector<Sample>& samples);

}  // namespace grader::samples

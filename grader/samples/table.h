// STAFF ONLY. The samples as tables, for people: those of the class by group, attacks by place.
#pragma once

#include <string>
#include <vector>

#include "grader/samples/sample.h"

namespace grader::inline samples {

// Writes Markdown. "gets" lists exercises with a line that don't pass, and their remaining points, if any.
std::string table_of(const std::vector<Sample>& samples);

}  // namespace grader::samples

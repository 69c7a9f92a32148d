// STAFF ONLY. Shows a student's file to staff, with messages at the lines that they are about.
#pragma once

#include "grader/result/result.h"
#include "hair/io/plot/html.h"

namespace grader::inline report {

hair::Html source_part(const ExerciseResult& exercise);

}  // namespace grader::report

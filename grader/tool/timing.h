// STAFF ONLY. timing.json: the cost of everything, beside the reference in an identical worker. The only file
// that differs from run to run.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "grader/tool/grading.h"

namespace grader {

using TimingByExercise = std::map<std::string, ExerciseTiming>;

// Adds to the file of an earlier run in `out`. `wall_seconds` and `graded` are those of this run.
void write_timing(const std::filesystem::path& out, const TimingByExercise& reference,
                  const std::map<std::string, TimingByExercise>& submissions, double wall_seconds, int graded,
                  int jobs);

}  // namespace grader

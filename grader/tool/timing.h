// STAFF ONLY. timing.json: what everything cost, beside the reference in an identical worker. The only file
// that differs from run to run.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "grader/tool/grading.h"

namespace grader {

using TimingByExercise = std::map<std::string, ExerciseTiming>;

// Adds to what an earlier run left in `out`. `wall_seconds` and `graded` are this run's.
void write_timing(const std::filesystem::path& out, const TimingByExercise& reference,
                  const std::map<std::string, TimingByExercise>& submissions, double wall_seconds, int graded,
                  int jobs);

}  // namespace grader

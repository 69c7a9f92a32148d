// STAFF ONLY. Runs the hidden suite as a separate program, with a job as input and the results as output. See
// grader/judge/main.cpp.
#pragma once

#include <filesystem>

#include "grader/judge/job.h"
#include "grader/result/suite_result.h"

namespace grader::inline grading {

// Throws std::runtime_error if the suite itself fails.
SuiteResult run_suite(const std::filesystem::path& suite, const SuiteJob& job);

}  // namespace grader::grading

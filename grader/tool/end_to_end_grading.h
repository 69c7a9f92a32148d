// STAFF ONLY. Runs all files of a submission together in the end-to-end scenes, which give no points.
#pragma once

#include <filesystem>

#include "grader/result/result.h"
#include "grader/tool/suite_jobs.h"

namespace grader {

// One worker for all of a submission's objects, which lie in the folders of `job`. Given exercises use the
// reference's objects, and exercises that can't be called use stubs: scenes that need a stub are not run.
SuiteJob end_to_end_job(const SuiteJobs& jobs, const std::filesystem::path& job,
                        const SubmissionResult& result);

}  // namespace grader

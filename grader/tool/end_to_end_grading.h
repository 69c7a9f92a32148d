// STAFF ONLY. All files of a submission together: the scenes that they run end to end, which give no points.
#pragma once

#include <filesystem>

#include "grader/report/result.h"
#include "grader/tool/suite_jobs.h"

namespace grader {

// One worker for all of a submission's objects, which lie in the folders of `job`. The reference's stand in for exercises
// that are given, and stubs for those that can't be called: scenes that need these are not run.
SuiteJob end_to_end_job(const SuiteJobs& jobs, const std::filesystem::path& job,
                        const SubmissionResult& result);

}  // namespace grader

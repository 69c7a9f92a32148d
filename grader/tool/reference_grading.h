// STAFF ONLY. Every batch begins with the reference in a worker like the students': it must pass, and its CPU time sets
// theirs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/report/study_result.h"
#include "grader/tool/suite_jobs.h"

namespace grader {

struct ReferenceGraded {
  std::map<std::string, ExerciseTiming> timing;  // by exercise, and of kRuns and kStudy
  std::optional<SubmissionStudy> study;          // beside itself: what is not 1 in its ratios is noise
  std::vector<std::string> problems;             // of studies, which are only shown: grades do without
};

// Throws std::runtime_error if it does not pass.
ReferenceGraded grade_reference(const SuiteJobs& jobs);

}  // namespace grader

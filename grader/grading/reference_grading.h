// STAFF ONLY. Every batch begins with the reference, compiled and asked as students' files are: it must pass,
// and its CPU time determines the students' limits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/grading/suite_jobs.h"

namespace grader::inline grading {

struct ReferenceGraded {
  TimingByExercise timing;            // by exercise, and for kStudy
  std::vector<std::string> problems;  // concern studies; they don't affect grades
};

// Throws std::runtime_error if the reference does not pass: then this machine or the suite is wrong.
ReferenceGraded grade_reference(const SuiteJobs& jobs, const Compiler& compiler);

}  // namespace grader::grading

// STAFF ONLY. One exercise of a submission: its file is compiled and linked in cages, and its hidden suite run against it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/intake/submission.h"
#include "grader/report/result.h"
#include "grader/tool/suite_jobs.h"

namespace grader {

// Without status, points and cases.
ExerciseResult describe(const Exercise& exercise);

// `job`: a folder for temporary files. What goes wrong on our side is thrown.
void grade_exercise(const SuiteJobs& jobs, const Compiler& compiler, const Exercise& exercise,
                    const Submission& submission, const std::filesystem::path& job, ExerciseResult& result,
                    ExerciseTiming& timing);

// The suite alone, against an object of `student`.
void run_cases(const SuiteJobs& jobs, const Exercise& exercise, const std::string& student,
               const std::filesystem::path& object, const std::filesystem::path& job, ExerciseResult& result,
               ExerciseTiming& timing);

// An exercise's status from those of its cases.
Status overall_status(const std::vector<CaseResult>& cases);

}  // namespace grader

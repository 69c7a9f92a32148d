// STAFF ONLY. Grades one exercise of a submission: compiles and links its file in cages, and runs its hidden
// suite.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/intake/submission.h"
#include "grader/report/result.h"
#include "grader/tool/suite_jobs.h"

namespace grader {

// The result without status, points and cases.
ExerciseResult describe(const Exercise& exercise);

// `job`: a folder for temporary files. `compiler_seconds`: the CPU time that compiler and linker may take. Throws for errors on our side.
void grade_exercise(const SuiteJobs& jobs, const Compiler& compiler, const Exercise& exercise,
                    const Submission& submission, const std::filesystem::path& job, double compiler_seconds,
                    ExerciseResult& result, ExerciseTiming& timing);

// Runs only the suite, against an object of `student`.
void run_cases(const SuiteJobs& jobs, const Exercise& exercise, const std::string& student,
               const std::filesystem::path& object, const std::filesystem::path& job, ExerciseResult& result,
               ExerciseTiming& timing);

// An exercise's status from those of its cases.
Status overall_status(const std::vector<CaseResult>& cases);

}  // namespace grader

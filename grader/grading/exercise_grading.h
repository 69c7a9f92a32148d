// STAFF ONLY. Grades one exercise of a submission: compiles and links its file in sandboxes, and runs its
// hidden suite.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/grading/suite_jobs.h"
#include "grader/intake/submission.h"
#include "grader/result/result.h"

namespace grader::inline grading {

inline constexpr std::size_t kMostSource = 64 << 10;  // bounds ExerciseResult::source

// Returns a category's share of an exercise's points for `held` cases, in whole points and exact: of 20
// points 38/57 for 9 of 12 cases are 10, but doubles make 9.99. All numbers count in thousandths.
double whole_points(double points, double weight, double weights, int held, int cases);

// Returns the result without status, points and cases.
ExerciseResult describe(const Exercise& exercise);

// `job` is a folder for temporary files, `compiler_seconds` the limit of compiler and linker in CPU time.
// Throws for errors on our side.
void grade_exercise(const SuiteJobs& jobs, const Compiler& compiler, const Exercise& exercise,
                    const Submission& submission, const std::filesystem::path& job, double compiler_seconds,
                    ExerciseResult& result, ExerciseTiming& timing);

// Every batch begins with the reference, compiled and asked as students' files are: its CPU time determines
// their limits. Throws std::runtime_error if it does not pass: then this machine or the suite is wrong.
TimingByExercise grade_reference(const SuiteJobs& jobs, const Compiler& compiler);

// Returns an exercise's status from those of its cases.
Status overall_status(const std::vector<CaseResult>& cases);

}  // namespace grader::grading

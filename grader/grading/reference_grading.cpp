// STAFF ONLY. Grades the reference as a submission.
#include "grader/grading/reference_grading.h"

#include <stdexcept>

#include "grader/course/input.h"
#include "grader/grading/exercise_grading.h"
#include "hair/io/files/read_file.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

// The worker's output may have the reason.
std::string also_said(const fs::path& log) {
  const std::string text = beginning_of(log, 400);
  return text.empty() ? "" : "; the worker says: " + printable(text, 400);
}

void grade_exercise_of_reference(const SuiteJobs& jobs, const Compiler& compiler, const Exercise& exercise,
                                 ExerciseTiming& timing) {
  const fs::path job = jobs.kit().new_job("reference-" + exercise.id);
  const Compiled compiled =
      compiler.compile(exercise, hair::bytes_of(jobs.settings().reference / exercise.id / exercise.file), job,
                       jobs.settings().course.budget.compiler_cpu_seconds);
  if (compiled.object.empty())
    throw std::runtime_error("the reference of " + exercise.id +
                             " does not compile: " + printable(compiled.log));
  timing.spent.compiler_cpu_seconds = compiled.made_in_seconds;
  ExerciseResult result;
  run_cases(jobs, exercise, "", compiled.object, job, result, timing);
  const std::string fails = "the reference fails its own suite for " + exercise.id;
  for (const CaseResult& one : result.cases) {
    if (one.status == Status::passed) continue;
    throw std::runtime_error(fails + ", in \"" + one.name + "\": " + one.feedback + "; " + one.detail +
                             also_said(job / kLog));
  }
  if (result.status != Status::passed)
    throw std::runtime_error(fails + ": " + result.feedback + " " + printable(result.staff_log));
}

}  // namespace

ReferenceGraded grade_reference(const SuiteJobs& jobs, const Compiler& compiler) {
  ReferenceGraded graded;
  for (const Exercise& exercise : jobs.settings().course.exercises) {
    if (!jobs.selected(exercise)) continue;
    grade_exercise_of_reference(jobs, compiler, exercise, graded.timing[exercise.id]);
  }
  return graded;
}

}  // namespace grader::grading

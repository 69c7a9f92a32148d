// STAFF ONLY.
#include "grader/tool/reference_grading.h"

#include <stdexcept>

#include "grader/tool/exercise_grading.h"

namespace grader {
namespace {

void run_end_to_end(const SuiteJobs& jobs, ReferenceGraded& graded) {
  SuiteJob suite = jobs.end_to_end(jobs.kit().new_job("reference-runs"));
  for (const Exercise& exercise : jobs.settings().course.exercises)
    suite.objects.push_back(jobs.reference_object(exercise));
  for (const RunResult& run : jobs.run(suite, graded.timing[kRuns]).runs)
    if (run.outcome != RunOutcome::same)
      throw std::runtime_error("the reference does not run as it should end to end, in \"" + run.name +
                               "\": " + run.feedback + "; " + run.detail);
  if (!jobs.settings().study) return;
  try {
    graded.study = jobs.run_study(jobs.study(suite), graded.timing[kStudy]).study.value();
  } catch (const std::exception& problem) {
    graded.problems.push_back(std::string("the studies: the reference's failed: ") + problem.what());
  }
}

}  // namespace

ReferenceGraded grade_reference(const SuiteJobs& jobs) {
  ReferenceGraded graded;
  for (const Exercise& exercise : jobs.settings().course.exercises) {
    if (!jobs.selected(exercise)) continue;
    ExerciseResult result;
    run_cases(jobs, exercise, "", jobs.reference_object(exercise),
              jobs.kit().new_job("reference-" + exercise.id), {}, result, graded.timing[exercise.id]);
    for (const CaseResult& one : result.cases)
      if (one.status != Status::passed)
        throw std::runtime_error("the reference fails its own suite for " + exercise.id + ", in \"" +
                                 one.name + "\": " + one.feedback + "; " + one.detail);
  }
  if (!jobs.settings().exercise) run_end_to_end(jobs, graded);
  return graded;
}

}  // namespace grader

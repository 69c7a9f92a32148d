// STAFF ONLY.
#include "grader/tool/grading.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/tool/end_to_end_grading.h"
#include "grader/tool/exercise_grading.h"
#include "grader/tool/isolation.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

// The settings, if this machine can do as they say.
const GradingSettings& checked(const GradingSettings& settings, const StagedKit& kit) {
  if (!settings.isolated) return settings;
  if (const std::string why = why_not_isolated(kit); !why.empty())
    throw BadInput("this machine can't isolate student code: " + why +
                   "; --unsafe-no-sandbox runs it all the same, and stamps the report");
  return settings;
}

}  // namespace

void check_isolation(const GradingSettings& settings) {
  checked(settings, StagedKit(settings.kit, settings.course));
}

Grading::Grading(GradingSettings settings)
    : settings_(std::move(settings)),
      made_by_(grader::made_by(settings_)),
      kit_(settings_.kit, settings_.course),
      compiler_(kit_, settings_.cache, settings_.isolated),
      jobs_(checked(settings_, kit_), kit_),
      base_fingerprint_(jobs_.fingerprint()),
      reference_(grade_reference(jobs_)) {
  jobs_.limit_by(reference_.timing);
}

std::string Grading::fingerprint(const Submission& submission) const {
  std::string all = base_fingerprint_ + "\n" + submission.name + "\n" + submission.problem + "\n" +
                    (submission.unreadable ? "unreadable\n" : "");
  for (const auto& [name, file] : submission.files)
    all += name + "\n" + sha256(file.text) + "\n" + file.problem + "\n";
  return sha256(all);
}

Graded Grading::grade(const Submission& submission) const {
  Graded graded;
  graded.result.name = submission.name;
  graded.result.note = submission.problem;
  graded.result.fingerprint = fingerprint(submission);
  graded.result.isolated = settings_.isolated;
  graded.result.images = settings_.images;
  const fs::path job = kit_.new_job("submission-" + submission.name);
  // Honest files take very different times: what earlier ones leave of their shares, later ones may take.
  double compiler_seconds = 0;
  for (const Exercise& exercise : settings_.course.exercises) {
    compiler_seconds += jobs_.allowance().compiler_cpu_seconds;
    if (!jobs_.selected(exercise)) continue;
    const fs::path folder = kit_.new_job(job.filename() / exercise.id);
    ExerciseResult result = describe(exercise);
    try {
      ExerciseTiming& timing = graded.timing[exercise.id];
      grade_exercise(jobs_, compiler_, exercise, submission, folder, compiler_seconds, result, timing);
      compiler_seconds = std::max(0.0, compiler_seconds - timing.spent.compiler_cpu_seconds);
    } catch (const std::exception& problem) {  // ours, not the student's; and it stops no other submission
      result = describe(exercise);
      result.status = Status::crashed;
      result.feedback =
          "The grader could not finish with this file; that is not your fault. The staff see why.";
      result.staff_log = problem.what();
      graded.result.fingerprint.clear();  // to be graded again
      graded.problems.push_back(submission.name + ": " + exercise.id + ": " + problem.what());
    }
    graded.result.exercises.push_back(std::move(result));
  }
  if (!settings_.exercise) {
    try {
      run_end_to_end(job, graded);
    } catch (const std::exception& problem) {
      graded.result.fingerprint.clear();
      graded.problems.push_back(submission.name + ": end to end: " + problem.what());
    }
  }
  std::error_code ignored;
  fs::remove_all(job, ignored);
  return graded;
}

void Grading::run_end_to_end(const fs::path& job, Graded& graded) const {
  const SuiteJob runs = end_to_end_job(jobs_, job, graded.result);
  graded.result.runs = jobs_.run(runs, graded.timing[kRuns]).runs;
  if (!reference_.study) return;
  try {
    graded.study = jobs_.run(jobs_.study(runs), graded.timing[kStudy]).study.value();
  } catch (const std::exception& problem) {  // the grade stands
    graded.problems.push_back(graded.result.name + ": study: " + problem.what());
  }
}

}  // namespace grader

// STAFF ONLY. Grades a submission, exercise by exercise and as a whole.
#include "grader/grading/grading.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/grading/exercise_grading.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNotFinal =
    "It took too long by the clock on the wall, so these points are not final: the staff look at it and "
    "grade it again.";

// A file may include headers that the reference's does not need: <regex> takes the compiler several seconds.
constexpr double kSpareCompilerSeconds = 15;

// Returns why a study does not call an exercise of a submission; nothing if it does.
std::string why_not_called(Status status) {
  switch (status) {
    case Status::missing:
      return "is missing";
    case Status::not_implemented:
      return "is not implemented yet";
    case Status::does_not_compile:
      return "does not compile";
    case Status::timed_out:
      return "takes too long";
    case Status::out_of_memory:
      return "takes too much memory";
    case Status::broke_rules:
      return "breaks the rules";
    case Status::not_taken:
      return "was not taken";
    case Status::unreadable:
      return "can't be read";
    default:
      return "";
  }
}

// Makes the job for all files of a submission together, in one worker: their objects lie in the folders of
// `job`. Given exercises use the reference's objects, and exercises that can't be called use stubs: scenes
// that need a stub are not studied.
SuiteJob study_job(const SuiteJobs& jobs, const fs::path& job, const SubmissionResult& result) {
  const StagedKit& kit = jobs.kit();
  SuiteJob suite = jobs.study(kit.new_job(job.filename() / kStudy));
  for (const Exercise& exercise : jobs.settings().course.exercises) {
    const std::string file = exercise.id + ".so";
    fs::path object = kit.folder() / (exercise.role == Role::given ? "lib" : "stub") / file;
    // Student code could read the reference's object of an exercise that is due later.
    if (exercise.role != Role::given && !jobs.settings().course.asks_for(exercise))
      suite.left_out.insert(exercise.id);
    for (const ExerciseResult& graded : result.exercises) {
      if (graded.id != exercise.id) continue;
      const fs::path compiled = job / exercise.id / file;
      std::string why = why_not_called(graded.status);
      if (why.empty() && !fs::exists(compiled)) why = "could not be graded";
      if (why.empty())
        object = compiled;
      else
        suite.unavailable[exercise.id] = why;
    }
    suite.objects.push_back(object);
  }
  return suite;
}

}  // namespace

Grading::Grading(GradingSettings settings, std::optional<TimingByExercise> reference)
    : settings_(std::move(settings)),
      made_by_(grader::made_by(settings_)),
      kit_(settings_.kit, settings_.course),
      compiler_(kit_, settings_.cache, settings_.isolation),
      jobs_(settings_, kit_),
      base_fingerprint_(jobs_.fingerprint()),
      reference_(reference ? std::move(*reference) : grade_reference(jobs_, compiler_)) {
  jobs_.limit_by(reference_);
}

std::string hash_of_files(const Submission& submission) {
  std::string all = submission.problem + "\n" + (submission.unreadable ? "unreadable\n" : "");
  for (const auto& [name, file] : submission.files)
    all += name + "\n" + sha256(file.text) + "\n" + file.problem + "\n";
  if (!submission.about.empty()) all += sha256(submission.about) + "\n";
  return sha256(all);
}

std::string Grading::fingerprint(const Submission& submission) const {
  std::string choices;  // names them in the report
  for (const auto& [name, file] : submission.files) choices += file.choice + "\n";
  return sha256(base_fingerprint_ + "\n" + drawn_from(submission) + "\n" + choices +
                hash_of_files(submission));
}

Graded Grading::grade(const Submission& submission, const AfterEach& after_each) const {
  Graded graded;
  graded.result.name = submission.name;
  graded.result.origin = submission.origin;
  graded.result.note = submission.problem;
  graded.result.about = submission.about;
  for (const auto& [name, file] : submission.files)
    if (!file.choice.empty()) graded.result.remarks.push_back(file.choice);
  graded.result.fingerprint = fingerprint(submission);
  graded.result.isolation = settings_.isolation;
  graded.result.images = settings_.images;
  graded.job = kit_.new_job("submission-" + submission.name);
  // Honest files take very different times: later files may use the rest of earlier ones' shares.
  double compiler_seconds = kSpareCompilerSeconds;
  for (const Exercise& exercise : settings_.course.exercises) {
    compiler_seconds += jobs_.compiler_seconds(exercise);
    if (!jobs_.selected(exercise)) continue;
    graded.result.exercises.push_back(describe(exercise));
    grade_one(submission, exercise, compiler_seconds, graded.result.exercises.back(), graded);
    if (after_each) after_each(graded.result);
  }
  finish(graded);
  return graded;
}

void Grading::grade_again(const Submission& submission, Graded& graded) const {
  const std::vector<std::string> ended = std::exchange(graded.result.ended_by_the_clock, {});
  if (graded.problems.empty()) graded.result.fingerprint = fingerprint(submission);
  for (ExerciseResult& result : graded.result.exercises) {
    if (std::ranges::count(ended, result.id) == 0) continue;
    const Exercise& exercise = *settings_.course.find(result.id);
    double compiler_seconds = kSpareCompilerSeconds + jobs_.compiler_seconds(exercise);
    fs::remove_all(graded.job / result.id);
    result = describe(exercise);
    grade_one(submission, exercise, compiler_seconds, result, graded);
  }
  finish(graded);
}

// Grades into `result`. `compiler_seconds` is the file's limit at the start, and the rest of it at the end.
void Grading::grade_one(const Submission& submission, const Exercise& exercise, double& compiler_seconds,
                        ExerciseResult& result, Graded& graded) const {
  try {
    const fs::path folder = kit_.new_job(graded.job.filename() / exercise.id);
    ExerciseTiming& timing = graded.timing[exercise.id] = {};
    grade_exercise(jobs_, compiler_, exercise, submission, folder, compiler_seconds, result, timing);
    compiler_seconds = std::max(0.0, compiler_seconds - timing.spent.compiler_cpu_seconds);
    if (jobs_.ended_by_the_clock(timing)) {
      graded.result.ended_by_the_clock.push_back(exercise.id);
      result.feedback += std::string(" ") + kNotFinal;
    }
  } catch (const std::exception& problem) {  // our own error, which stops no other submission
    result = describe(exercise);
    result.status = Status::crashed;
    result.feedback =
        "The grader could not finish with this file; that is not your fault. The staff see why.";
    result.staff_log = problem.what();
    graded.result.fingerprint.clear();  // grades it again next time
    graded.problems.push_back(submission.name + ": " + exercise.id + ": " + problem.what());
  }
}

// Grades all files together, at the end.
void Grading::finish(Graded& graded) const {
  if (studies()) {
    try {
      graded.study =
          jobs_.run_study(study_job(jobs_, graded.job, graded.result), graded.timing[kStudy]).study.value();
    } catch (const std::exception& problem) {  // the grade stands
      graded.problems.push_back(graded.result.name + ": study: " + problem.what());
    }
  }
  if (!graded.result.ended_by_the_clock.empty()) {
    graded.result.fingerprint.clear();  // grades it again next time
    return;
  }
  std::error_code ignored;
  fs::remove_all(graded.job, ignored);
}

}  // namespace grader::grading

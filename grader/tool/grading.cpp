// STAFF ONLY.
#include "grader/tool/grading.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/tool/isolation.h"
#include "grader/tool/secret.h"
#include "hair/render/renderer.h"
#include "solver/timing.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLog = 16 << 10;  // of what a worker printed
constexpr int kLeastCpuSeconds = 2;
constexpr double kTimesReference = 20;  // a student's code may take this many times the reference's CPU time

std::string beginning_of(const fs::path& file, std::size_t most) {
  std::ifstream in(file, std::ios::binary);
  std::string text(most, '\0');
  in.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

ExerciseResult describe(const Exercise& exercise) {
  ExerciseResult result;
  result.id = exercise.id;
  result.title = exercise.title;
  result.file = exercise.file;
  result.extra_credit = exercise.role == Role::optional;
  result.max_points = exercise.points;
  return result;
}

// What a worker may take, of the reference's.
int cpu_limit(double reference) {
  return std::max(kLeastCpuSeconds, static_cast<int>(std::ceil(kTimesReference * reference)));
}

// For the suite and in the timing: all exercises end to end, and the same with more steps and fewer.
constexpr const char* kRuns = "runs";
constexpr const char* kStudy = "study";

// Why an exercise of a submission is not called in scenes that run end to end; nothing if it is.
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
    default:
      return "";
  }
}

// What draws here: OpenGL and its version. Throws BadInput where there is none.
std::string what_draws() {
  try {
    hair::RenderSettings least;
    least.width = least.height = 16;
    least.shadows = false;
    return hair::Renderer(least).about();
  } catch (const hair::NoOpenGl& none) {
    throw BadInput(
        std::string("this machine can't draw: ") + none.what() +
        "; install libosmesa6, or grade with --no-images, which leaves the pictures' points to the "
        "other categories and stamps the report");
  }
}

}  // namespace

Status overall_status(const std::vector<CaseResult>& cases) {
  auto any = [&](Status status) {
    return std::any_of(cases.begin(), cases.end(), [&](const CaseResult& c) { return c.status == status; });
  };
  for (Status status : {Status::broke_rules, Status::out_of_memory, Status::timed_out, Status::crashed,
                        Status::does_not_compile})
    if (any(status)) return status;
  if (!any(Status::wrong) && !any(Status::not_implemented)) return Status::passed;
  if (any(Status::passed)) return Status::partly;
  return any(Status::not_implemented) ? Status::not_implemented : Status::wrong;
}

Grading::Grading(GradingSettings settings)
    : settings_(std::move(settings)),
      kit_(settings_.kit, settings_.course),
      compiler_(kit_, settings_.cache, settings_.isolated) {
  if (settings_.isolated) {
    if (const std::string why = why_not_isolated(kit_); !why.empty())
      throw BadInput("this machine can't isolate student code: " + why +
                     "; --unsafe-no-sandbox runs it all the same, and stamps the report");
  }
  const std::string suite = sha256_of(settings_.suite), drawn = settings_.images ? what_draws() : "";
  base_fingerprint_ = kit_.hash() + suite + sha256_of(settings_.scenes) + sha256(settings_.secret) +
                      (settings_.isolated ? "" : "unsafe") + (settings_.images ? drawn : "no images");
  if (settings_.images) pictures_ = settings_.cache / "pictures" / sha256(suite + drawn);
  for (const Exercise& exercise : settings_.course.exercises)
    if (selected(exercise))
      base_fingerprint_ += exercise.id + to_string(exercise.role) + std::to_string(exercise.points);
  measure_reference();
}

bool Grading::selected(const Exercise& exercise) const {
  return (exercise.role == Role::assigned || exercise.role == Role::optional) &&
         (!settings_.exercise || *settings_.exercise == exercise.id);
}

std::string Grading::fingerprint(const Submission& submission) const {
  std::string all = base_fingerprint_ + "\n" + submission.name + "\n" + submission.problem + "\n";
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
  for (const Exercise& exercise : settings_.course.exercises) {
    if (!selected(exercise)) continue;
    const fs::path folder = kit_.new_job(job.filename() / exercise.id);
    ExerciseResult result = describe(exercise);
    try {
      grade_exercise(exercise, submission, folder, result, graded.timing[exercise.id]);
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

void Grading::grade_exercise(const Exercise& exercise, const Submission& submission, const fs::path& job,
                             ExerciseResult& result, ExerciseTiming& timing) const {
  auto without_cases = [&](Status status, const std::string& feedback) {
    result.status = status;
    result.feedback = feedback;
  };
  if (!submission.problem.empty()) return without_cases(Status::missing, submission.problem);
  const auto file = submission.files.find(exercise.file);
  if (file == submission.files.end()) return without_cases(Status::missing, sentence_for(Status::missing));
  if (!file->second.problem.empty()) return without_cases(Status::missing, file->second.problem);

  const timing::Stopwatch compiling;
  const Compiled compiled = compiler_.compile(exercise, file->second.text, job);
  timing.compile_seconds = compiling.seconds();
  result.compiler_messages = compiled.messages;
  result.staff_log = compiled.log;
  if (compiled.object.empty())
    return without_cases(Status::does_not_compile, sentence_for(Status::does_not_compile));

  run_cases(exercise, submission.name, compiled.object, job, result, timing);
}

SuiteJob Grading::suite_job(const std::string& exercise, const fs::path& job) const {
  SuiteJob suite;
  suite.exercise = exercise;
  suite.kit = kit_.folder();
  suite.log = job / "output";
  suite.isolated = settings_.isolated;
  suite.cpu_seconds = kLeastCpuSeconds;
  if (const auto reference = reference_.find(exercise); reference != reference_.end())
    suite.cpu_seconds = cpu_limit(reference->second.worker_cpu_seconds);
  return suite;
}

std::optional<SuiteJob::WholeRun> Grading::whole_run(const std::string& exercise) const {
  const fs::path scene = settings_.scenes / (exercise + ".json");
  if (!fs::exists(scene)) return {};
  SuiteJob::WholeRun run;
  run.scene = scene;
  run.seed = seed_for(settings_.secret, "the class", exercise);  // no submission's name has a space
  for (const Exercise& one : settings_.course.exercises) run.exercises.push_back(one.id);
  run.cpu_seconds = kLeastCpuSeconds;
  if (const auto reference = reference_.find(exercise); reference != reference_.end())
    run.cpu_seconds = cpu_limit(reference->second.run_cpu_seconds);
  return run;
}

SuiteResult Grading::timed(const SuiteJob& job, ExerciseTiming& timing) const {
  const timing::Stopwatch running;
  SuiteResult found = run_suite(settings_.suite, job);
  timing.suite_seconds = running.seconds();
  timing.worker_cpu_seconds = found.cpu_seconds;
  timing.worker_starts = found.starts;
  timing.run_cpu_seconds = found.run_cpu_seconds;
  timing.picture_cpu_seconds = found.picture_cpu_seconds;
  return found;
}

void Grading::run_cases(const Exercise& exercise, const std::string& student, const fs::path& object,
                        const fs::path& job, ExerciseResult& result, ExerciseTiming& timing) const {
  SuiteJob suite = suite_job(exercise.id, job);
  suite.seed = seed_for(settings_.secret, student, exercise.id);
  for (const std::string& id : exercise.prerequisites)
    suite.objects.push_back(kit_.folder() / "lib" / (id + ".so"));
  suite.objects.push_back(object);
  suite.whole_run = whole_run(exercise.id);
  if (pictures_ && suite.whole_run)
    suite.pictures = *pictures_ / sha256(sha256_of(suite.whole_run->scene) + suite.whole_run->seed);
  SuiteResult found = timed(suite, timing);
  double weights = 0;
  for (const CaseResult& one : found.cases) weights += one.max_points;
  const bool nothing_to_call = std::all_of(found.cases.begin(), found.cases.end(), [](const CaseResult& one) {
    return one.status == Status::does_not_compile;
  });
  if (nothing_to_call) {
    result.status = Status::does_not_compile;
    result.feedback = "The file compiles, but does not define the functions of " + exercise.header +
                      " as they are declared there.";
    result.staff_log += found.cases.front().detail + "\n";
    return;
  }
  result.points = 0;
  for (CaseResult& one : found.cases) {
    one.points *= exercise.points / weights;
    one.max_points *= exercise.points / weights;
    result.points += one.points;
  }
  result.cases = std::move(found.cases);
  result.pictures = std::move(found.pictures);
  result.status = overall_status(result.cases);
  result.feedback = sentence_for(result.status);
  result.staff_log += beginning_of(suite.log, kMostLog);
}

// One worker for all of a submission's objects. The reference's stand in for exercises that are given, and stubs
// for those that can't be called: scenes that need these are not run.
SuiteJob Grading::end_to_end_job(const fs::path& job, const SubmissionResult& result) const {
  SuiteJob suite = suite_job(kRuns, kit_.new_job(job.filename() / kRuns));
  for (const Exercise& exercise : settings_.course.exercises) {
    const std::string file = exercise.id + ".so";
    fs::path object = kit_.folder() / (exercise.role == Role::given ? "lib" : "stub") / file;
    if (exercise.role == Role::absent) suite.left_out.push_back(exercise.id);
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
  if (pictures_) suite.pictures = *pictures_ / kRuns;
  return suite;
}

void Grading::run_end_to_end(const fs::path& job, Graded& graded) const {
  const SuiteJob runs = end_to_end_job(job, graded.result);
  graded.result.runs = timed(runs, graded.timing[kRuns]).runs;
  if (!reference_study_) return;
  try {
    graded.study = study(runs, graded.timing[kStudy]);
  } catch (const std::exception& problem) {  // the grade stands
    graded.problems.push_back(graded.result.name + ": study: " + problem.what());
  }
}

// Scenes as they run end to end, in two workers of which one has nothing but the reference's objects.
SubmissionStudy Grading::study(SuiteJob runs, ExerciseTiming& timing) const {
  runs.exercise = kStudy;
  runs.motions = settings_.cache / "motions" / sha256_of(settings_.suite);
  for (const Exercise& exercise : settings_.course.exercises)
    runs.reference_objects.push_back(kit_.folder() / "lib" / (exercise.id + ".so"));
  return timed(runs, timing).study.value();
}

// Every batch begins with the reference in a worker like the students': it must pass, and its CPU time sets
// theirs.
void Grading::measure_reference() {
  std::map<std::string, ExerciseTiming> measured;
  for (const Exercise& exercise : settings_.course.exercises) {
    if (!selected(exercise)) continue;
    const fs::path job = kit_.new_job("reference-" + exercise.id);
    ExerciseResult result;
    run_cases(exercise, "", kit_.folder() / "lib" / (exercise.id + ".so"), job, result,
              measured[exercise.id]);
    for (const CaseResult& one : result.cases)
      if (one.status != Status::passed)
        throw std::runtime_error("the reference fails its own suite for " + exercise.id + ", in \"" +
                                 one.name + "\": " + one.feedback + "; " + one.detail);
  }
  if (!settings_.exercise) {
    SuiteJob suite = suite_job(kRuns, kit_.new_job("reference-runs"));
    if (pictures_) suite.pictures = *pictures_ / kRuns;
    for (const Exercise& exercise : settings_.course.exercises)
      suite.objects.push_back(kit_.folder() / "lib" / (exercise.id + ".so"));
    for (const RunResult& run : timed(suite, measured[kRuns]).runs)
      if (run.outcome != RunOutcome::same)
        throw std::runtime_error("the reference does not run as it should end to end, in \"" + run.name +
                                 "\": " + run.feedback + "; " + run.detail);
    if (settings_.study) {
      try {
        reference_study_ = study(suite, measured[kStudy]);
      } catch (const std::exception& problem) {  // studies are only shown: grades do without
        problems_.push_back(std::string("the studies: the reference's failed: ") + problem.what());
      }
    }
  }
  reference_ = std::move(measured);
}

}  // namespace grader

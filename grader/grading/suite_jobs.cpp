// STAFF ONLY. Gives hidden suites their folders, seeds and limits.
#include "grader/grading/suite_jobs.h"

#include <signal.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/grading/secret.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "grader/sandbox/processes/descriptor.h"
#include "hair/io/files/start_program.h"
#include "hair/render/opengl/renderer.h"
#include "solver/timing.h"

namespace grader::inline grading {

namespace {

namespace fs = std::filesystem;

constexpr int kLeastCpuSeconds = 2;
constexpr int kLeastRunCpuSeconds = 3;  // a run also has a bound of its own: see grader/judge/run/runner.cpp
// A worker, all workers of an exercise, and the suite while it asks them may take this many times the
// reference's CPU time and messages.
constexpr double kTimesReference = 20;
constexpr double kTimesCompiled = 2.25, kLeastCompilerSeconds = 5;
constexpr double kReferenceWallSeconds = 1e6;  // a busy machine is slow, but can grade

// Returns a worker's limit for the reference's time.
int cpu_limit(double reference) {
  return std::max(kLeastCpuSeconds, static_cast<int>(std::ceil(kTimesReference * reference)));
}

constexpr std::size_t kMostOutput = std::size_t{16} << 20;
// The suite's watchdog ends a student's worker long before; this limit is for the suite itself.
constexpr double kMostSeconds = 1200;

// Runs a trusted program with `input` on its standard input, and returns its standard output.
std::string run_trusted(const fs::path& program, const std::string& input) {
  Pipe in = make_pipe(), out = make_pipe();
  const std::string name = program.string();
  const pid_t process =
      hair::start_program({.words = {name}, .input = in.read_end.get(), .output = out.write_end.get()});
  in.read_end.close();
  out.write_end.close();
  if (write(in.write_end.get(), input.data(), input.size()) != static_cast<ssize_t>(input.size()))
    throw std::runtime_error(name + " does not read its job");
  in.write_end.close();
  const std::string output = read_all(out.read_end, kMostOutput, kMostSeconds);
  out.read_end.close();
  if (output.empty() || output.back() != '\n')
    kill(process, SIGKILL);  // it has not ended, and we don't wait for it
  const std::optional<int> code = hair::exit_code_of(process);
  if (code != 0)
    throw std::runtime_error(name + " failed " +
                             (code ? "with exit code " + std::to_string(*code) : "by a signal"));
  return output;
}

// Throws std::runtime_error if the suite itself fails.
SuiteResult run_suite(const fs::path& suite, const SuiteJob& job) {
  const std::string output = run_trusted(suite, to_json(job));
  try {
    return from_json_text<SuiteResult>(output, suite.string());
  } catch (const BadInput& error) {  // our own error, not the input's
    throw std::runtime_error(error.what());
  }
}

SuiteResult timed(const fs::path& program, const SuiteJob& job, ExerciseTiming& timing) {
  const timing::Stopwatch running;
  SuiteResult found = run_suite(program, job);
  timing.suite_seconds = running.seconds();
  timing.worker_cpu_seconds = found.cpu_seconds;
  timing.worker_starts = found.starts;
  const double compiler = timing.spent.compiler_cpu_seconds;
  timing.spent = found.spent;
  timing.spent.compiler_cpu_seconds = compiler;
  timing.run_cpu_seconds = found.run_cpu_seconds;
  timing.picture_cpu_seconds = found.picture_cpu_seconds;
  return found;
}

// Names the renderer: OpenGL and its version. Throws BadInput if there is none.
std::string what_draws() {
  try {
    hair::RenderSettings least;
    least.width = least.height = 16;
    least.shadows = false;
    return hair::Renderer(least).about();
  } catch (const hair::NoOpenGl& none) {
    throw BadInput(
        std::string("this machine can't draw: ") + none.what() +
        "; install libosmesa6, or grade with --no-images, which judges whole runs without pictures and "
        "stamps the report");
  }
}

}  // namespace

SuiteJobs::SuiteJobs(const GradingSettings& settings, const StagedKit& kit)
    : settings_(settings),
      kit_(kit),
      suite_hash_(sha256(sha256_of(settings.suite) + sha256_of(settings.runners))),
      drawn_(settings.images ? what_draws() : "") {
  if (settings_.images) pictures_ = settings_.cache / "pictures" / sha256(suite_hash_ + drawn_);
}

std::string SuiteJobs::fingerprint() const {
  std::string all = kit_.hash() + suite_hash_ + sha256_of(settings_.scenes) + sha256(settings_.secret) +
                    to_string(settings_.isolation) + (settings_.images ? drawn_ : "no images") +
                    (settings_.course.partial ? "partial" : "");
  for (const BudgetField& field : budget_fields())
    all += std::string(field.key) + std::to_string(settings_.course.budget.*field.value);
  for (const Exercise& exercise : settings_.course.exercises)
    if (selected(exercise)) all += exercise.id + to_string(exercise.role) + std::to_string(exercise.points);
  return all;
}

bool SuiteJobs::selected(const Exercise& exercise) const {
  return settings_.course.asks_for(exercise) && (!settings_.exercise || *settings_.exercise == exercise.id);
}

SuiteJob SuiteJobs::job(const std::string& exercise, const fs::path& folder) const {
  SuiteJob suite;
  suite.exercise = exercise;
  suite.kit = kit_.folder();
  suite.log = folder / kLog;
  suite.isolation = settings_.isolation;
  suite.cpu_seconds = kLeastCpuSeconds;
  suite.allowance = allowance(exercise);
  if (const auto reference = reference_.find(exercise); reference != reference_.end())
    suite.cpu_seconds = cpu_limit(reference->second.worker_cpu_seconds);
  if (reference_.empty()) suite.allowance.wall_seconds = kReferenceWallSeconds;
  return suite;
}

bool SuiteJobs::ended_by_the_clock(const ExerciseTiming& timing) const {
  return timing.spent.wall_seconds > share().wall_seconds;
}

Budget SuiteJobs::share() const {
  const auto parts = std::ranges::count_if(settings_.course.exercises,
                                           [](const Exercise& one) { return is_asked_for(one.role); });
  return share_of(settings_.course.budget, std::max(1, static_cast<int>(parts)));
}

Budget SuiteJobs::allowance(const std::string& exercise) const {
  Budget most = share();
  const auto reference = reference_.find(exercise);
  if (reference == reference_.end()) return most;
  for (const BudgetField& field : budget_fields()) {
    const double limit = std::max(field.least, kTimesReference * reference->second.spent.*field.value);
    if (field.least > 0) most.*field.value = std::min(most.*field.value, limit);
  }
  return most;
}

double SuiteJobs::compiler_seconds(const Exercise& exercise) const {
  double own = 0, all = 0;
  int files = 0;
  for (const auto& [id, timing] : reference_) {
    const double seconds = timing.spent.compiler_cpu_seconds;
    if (id == exercise.id) own = seconds;
    all += seconds;
    files += seconds > 0 ? 1 : 0;
  }
  const double most = share().compiler_cpu_seconds;
  return files == 0 ? most
                    : std::min(most, std::max(kLeastCompilerSeconds, kTimesCompiled * (own + all / files)));
}

std::optional<WholeRunJob> SuiteJobs::whole_run(const std::string& exercise) const {
  const fs::path scene = settings_.scenes / (exercise + ".json");
  if (!fs::exists(scene)) return {};
  WholeRunJob run;
  run.scene = scene;
  run.seed = seed_for(settings_.secret, "the class", exercise);  // no submission's name has a space
  run.runner = settings_.runners / (exercise + ".so");
  run.cpu_seconds = kLeastRunCpuSeconds;
  if (const auto reference = reference_.find(exercise); reference != reference_.end())
    run.cpu_seconds = std::max(kLeastRunCpuSeconds, cpu_limit(reference->second.run_cpu_seconds));
  return run;
}

SuiteJob SuiteJobs::cases(const Exercise& exercise, const std::string& student, const fs::path& object,
                          const fs::path& folder) const {
  SuiteJob suite = job(exercise.id, folder);
  suite.seed = seed_for(settings_.secret, student, exercise.id);
  suite.provided = exercise.prerequisites;
  suite.objects.push_back(object);
  suite.whole_run = whole_run(exercise.id);
  if (pictures_ && suite.whole_run)
    suite.pictures = *pictures_ / sha256(sha256_of(suite.whole_run->scene) + suite.whole_run->seed);
  return suite;
}

SuiteJob SuiteJobs::study(const fs::path& folder) const {
  SuiteJob study = job("runs", folder);
  study.motions = settings_.cache / "motions" / sha256_of(settings_.study_program);
  for (const Exercise& exercise : settings_.course.exercises)
    study.reference_objects.push_back(kit_.folder() / "lib" / (exercise.id + ".so"));
  return study;
}

SuiteResult SuiteJobs::run(const SuiteJob& job, ExerciseTiming& timing) const {
  const Processors::Lease processor(processors_);
  return timed(settings_.suite, job, timing);
}

// A study times methods that may use several threads.
SuiteResult SuiteJobs::run_study(const SuiteJob& job, ExerciseTiming& timing) const {
  return timed(settings_.study_program, job, timing);
}

}  // namespace grader::grading

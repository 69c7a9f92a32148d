// STAFF ONLY. Compiles an exercise and runs its cases.
#include "grader/grading/exercise_grading.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "grader/course/input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/plot/readable.h"
#include "solver/timing.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLog = 16 << 10;  // bounds a worker's output

// Returns the beginning of a worker's output.
std::string beginning_of(const fs::path& log, std::size_t most) {
  std::ifstream in(log, std::ios::binary);
  std::string text(most, '\0');
  in.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

}  // namespace

double whole_points(double points, double weight, double weights, int held, int cases) {
  const auto thousandths = [](double value) { return std::llround(1000 * value); };
  const long long whole =
      thousandths(points) * thousandths(weight) * held / (thousandths(weights) * 1000 * cases);
  return static_cast<double>(whole);
}

ExerciseResult describe(const Exercise& exercise) {
  return {.id = exercise.id,
          .title = exercise.title,
          .file = exercise.file,
          .extra_credit = exercise.role == Role::optional,
          .max_points = exercise.points};
}

Status overall_status(const std::vector<CaseResult>& cases) {
  auto any = [&](Status status) {
    return std::any_of(cases.begin(), cases.end(), [&](const CaseResult& c) { return c.status == status; });
  };
  for (Status status : {Status::broke_rules, Status::out_of_memory, Status::timed_out, Status::crashed,
                        Status::does_not_compile})
    if (any(status)) return status;
  if (!any(Status::wrong) && !any(Status::not_implemented)) return Status::passed;
  const bool gives_points =
      std::any_of(cases.begin(), cases.end(), [](const CaseResult& c) { return c.points > 0; });
  if (any(Status::passed) || gives_points) return Status::partly;
  return any(Status::not_implemented) ? Status::not_implemented : Status::wrong;
}

namespace {

// Runs only the suite, against an object of `student`.
void run_cases(const SuiteJobs& jobs, const Exercise& exercise, const std::string& student,
               const fs::path& object, const fs::path& job, ExerciseResult& result, ExerciseTiming& timing) {
  const SuiteJob suite = jobs.cases(exercise, student, object, job);
  SuiteResult found = jobs.run(suite, timing);
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
    if (jobs.settings().course.partial && one.cases > 0)
      one.points = whole_points(exercise.points, one.max_points, weights, one.held, one.cases);
    else
      one.points *= exercise.points / weights;
    one.max_points *= exercise.points / weights;
    result.points += one.points;
  }
  result.cases = std::move(found.cases);
  result.pictures = std::move(found.pictures);
  result.motions = std::move(found.motions);
  result.status = overall_status(result.cases);
  result.feedback = sentence_for(result.status);
  result.staff_log += beginning_of(suite.log, kMostLog);
}

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

void grade_exercise(const SuiteJobs& jobs, const Compiler& compiler, const Exercise& exercise,
                    const Submission& submission, const fs::path& job, double compiler_seconds,
                    ExerciseResult& result, ExerciseTiming& timing) {
  auto without_cases = [&](Status status, const std::string& feedback) {
    result.status = status;
    result.feedback = feedback;
  };
  if (!submission.problem.empty())
    return without_cases(submission.unreadable ? Status::unreadable : Status::not_taken, submission.problem);
  const auto file = submission.files.find(exercise.file);
  if (file == submission.files.end()) return without_cases(Status::missing, sentence_for(Status::missing));
  if (!file->second.problem.empty()) return without_cases(Status::not_taken, file->second.problem);

  result.source = hair::valid_utf8(file->second.text.substr(0, kMostSource));
  const timing::Stopwatch compiling;
  const Compiled compiled = compiler.compile(exercise, file->second.text, job, compiler_seconds);
  timing.compile_seconds = compiling.seconds();
  timing.spent.compiler_cpu_seconds = compiled.cpu_seconds;
  result.compiler_messages = compiled.messages;
  result.staff_log = compiled.log;
  if (compiled.object.empty())
    return without_cases(Status::does_not_compile, sentence_for(Status::does_not_compile));

  run_cases(jobs, exercise, drawn_from(submission), compiled.object, job, result, timing);
}

TimingByExercise grade_reference(const SuiteJobs& jobs, const Compiler& compiler) {
  TimingByExercise timing;
  for (const Exercise& exercise : jobs.settings().course.exercises)
    if (jobs.selected(exercise)) grade_exercise_of_reference(jobs, compiler, exercise, timing[exercise.id]);
  return timing;
}

}  // namespace grader::grading

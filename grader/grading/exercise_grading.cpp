// STAFF ONLY. Compiles an exercise and runs its cases.
#include "grader/grading/exercise_grading.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "grader/judge/memory_points.h"
#include "grader/sandbox/processes/identity.h"
#include "hair/io/plot/readable.h"
#include "solver/timing.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLog = 16 << 10;  // bounds a worker's output

// Returns the function of a memory error. A line number would be one of hundreds, and code could choose it by
// a hidden input.
std::string function_of(const Exercise& exercise, int call) {
  const auto number = static_cast<std::size_t>(call);
  return call >= 0 && number < exercise.functions.size() ? hair::plain_name(exercise.functions[number]) : "";
}

}  // namespace

std::string beginning_of(const fs::path& log, std::size_t most) {
  std::ifstream in(log, std::ios::binary);
  std::string text(most, '\0');
  in.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

Compiled compile_with_sanitizers(const Compiler& compiler, const Exercise& exercise,
                                 const std::string& source, const fs::path& job, double cpu_seconds) {
  const fs::path folder = job / "sanitised";
  fs::create_directory(folder);
  share_with_sandbox(folder, false);
  return compiler.compile(exercise, source, folder, cpu_seconds, Build::sanitised);
}

double whole_points(double points, double weight, double weights, int held, int cases) {
  const auto thousandths = [](double value) { return std::llround(1000 * value); };
  const long long whole =
      thousandths(points) * thousandths(weight) * held / (thousandths(weights) * 1000 * cases);
  return static_cast<double>(whole);
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

  std::optional<Compiled> sanitised;
  double compiler_cpu_seconds = compiled.cpu_seconds;
  if (jobs.settings().memory_errors) {
    const timing::Stopwatch once_more;
    const Compiled& checked = sanitised.emplace(compile_with_sanitizers(
        compiler, exercise, file->second.text, job, compiler_seconds - compiled.cpu_seconds));
    timing.compile_seconds += once_more.seconds();
    compiler_cpu_seconds += checked.cpu_seconds;
    if (checked.object.empty())
      result.staff_log += "memory errors were not looked for: " +
                          (checked.switched_off.empty()
                               ? "it does not compile with sanitizers:\n" + checked.messages + checked.log
                               : checked.switched_off + "\n");
  }
  timing.spent.compiler_cpu_seconds = compiler_cpu_seconds;

  run_cases(jobs, exercise, drawn_from(submission), compiled.object, job, sanitised, result, timing);
}

void run_cases(const SuiteJobs& jobs, const Exercise& exercise, const std::string& student,
               const fs::path& object, const fs::path& job, const std::optional<Compiled>& sanitised,
               ExerciseResult& result, ExerciseTiming& timing) {
  SuiteJob suite = jobs.cases(exercise, student, object, job);
  if (sanitised) suite.sanitised = sanitised->object;
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
  if (sanitised && found.memory && !found.memory->message.empty()) {
    const std::string function = function_of(exercise, found.memory->call);
    const std::string place = found.memory->call < 0 ? ""
                              : function.empty()     ? ", in " + exercise.file
                                                     : ", in a call of " + function;
    for (CaseResult& one : found.cases) {
      if (one.name != kMemoryTitle) continue;
      one.memory_error = one.feedback = found.memory->message + place + ".";
      one.memory_error_in = function;
    }
  }
  if (sanitised && !sanitised->switched_off.empty())
    for (CaseResult& one : found.cases)
      if (one.name == kMemoryTitle && one.status != Status::passed) one.feedback = sanitised->switched_off;
  result.cases = std::move(found.cases);
  result.pictures = std::move(found.pictures);
  result.motions = std::move(found.motions);
  result.status = overall_status(result.cases);
  result.feedback = sentence_for(result.status);
  if (!jobs.settings().memory_errors)
    result.feedback +=
        " Memory errors were not looked for on this machine; their point went to the largest category.";
  result.staff_log += beginning_of(suite.log, kMostLog);
}

}  // namespace grader::grading

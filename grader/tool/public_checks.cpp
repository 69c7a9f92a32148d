// STAFF ONLY. Compiles a hand-in, and runs the public checks' programs with its objects.
#include "grader/tool/public_checks.h"

#include <fcntl.h>

#include <algorithm>
#include <sstream>

#include "grader/grading/exercise_grading.h"
#include "grader/sandbox/sandboxed_process.h"
#include "grader/sandbox/system_mounts.h"
#include "hair/io/files/read_file.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

constexpr double kCompilerSeconds = 20;  // is twice its share in grading, since it is early
constexpr int kCpuSeconds = 20;          // right programs take one or two
constexpr std::size_t kMostSaid = 64 << 10;
constexpr std::size_t kMostOfOne = 3000;  // bounds a check's output
constexpr const char* kPrlimit = "/usr/bin/prlimit";

std::string beginning(const std::string& text) {
  return text.size() <= kMostOfOne ? text : text.substr(0, kMostOfOne) + "\n...";
}

CaseResult category(const std::string& name, Status status, const std::string& says) {
  CaseResult one;
  one.name = name;
  one.status = status;
  one.feedback = beginning(says);
  return one;
}

}  // namespace

std::vector<CaseResult> checks_in(const std::string& output, bool ended_well) {
  const std::string run = "[ RUN      ] ", passed = "[       OK ] ", failed = "[  FAILED  ] ";
  std::vector<CaseResult> checks;
  std::string says;
  bool inside = false, any_failed = false;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(run)) {
      checks.push_back(category(line.substr(run.size()), Status::crashed, ""));
      says.clear();
      inside = true;
    } else if (inside && (line.starts_with(passed) || line.starts_with(failed))) {
      const bool well = line.starts_with(passed);
      any_failed |= !well;
      checks.back() = category(checks.back().name, well ? Status::passed : Status::wrong, well ? "" : says);
      says.clear();
      inside = false;
    } else if (!line.starts_with("[---") && !line.starts_with("[===")) {
      says += line + "\n";
    }
  }
  if (inside) checks.back() = category(checks.back().name, Status::crashed, "It broke off here.\n" + says);
  if (!inside && !any_failed && !ended_well) checks.push_back(category("All checks", Status::wrong, says));
  return checks;
}

PublicChecks::PublicChecks(const Compiler& compiler, const fs::path& programs, const fs::path& golden,
                           fs::path golden_inside, Isolation isolation)
    : compiler_(compiler),
      kit_(compiler.toolchain().kit()),
      staged_(kit_.new_job("checks")),
      golden_inside_(std::move(golden_inside)),
      isolation_(isolation) {
  fs::copy(programs, staged_ / "programs", fs::copy_options::recursive);
  fs::copy(golden, staged_ / "golden", fs::copy_options::recursive);
  for (const auto& entry : fs::recursive_directory_iterator(staged_))
    fs::permissions(entry.path(), fs::perms(0755));
}

PublicChecks::Ran PublicChecks::run(const Exercise& exercise, const fs::path& job) const {
  const fs::path program = staged_ / "programs" / exercise.id;
  Sandbox sandbox;
  sandbox.isolation = isolation_;
  sandbox.roots = kit_.roots();
  sandbox.mounts = library_mounts(isolation_, {program, kPrlimit});
  sandbox.mounts.push_back({kPrlimit, kPrlimit});
  sandbox.mounts.push_back({program, "/check"});
  sandbox.mounts.push_back({staged_ / "golden", golden_inside_});
  sandbox.mounts.push_back({job / exercise.id / (exercise.id + ".so"), "/objects/" + exercise.id + ".so"});
  for (const std::string& id : exercise.prerequisites) {
    const fs::path own = job / id / (id + ".so");
    sandbox.mounts.push_back(
        {fs::exists(own) ? own : kit_.folder() / "stub" / (id + ".so"), "/objects/" + id + ".so"});
  }
  sandbox.syscalls = Syscalls::toolchain;  // prlimit starts it
  sandbox.limits.cpu_seconds = kCpuSeconds;
  sandbox.limits.wall_seconds = 10 * kCpuSeconds;
  Pipe output = make_pipe();
  SandboxedProcess process(sandbox, with_inner_limits(sandbox.limits, {"/check", "--gtest_color=no"}), -1, -1,
                           output.write_end.get());
  output.write_end.close();
  Ran ran;
  ran.output = read_both_ends(output.read_end, kMostSaid, sandbox.limits.wall_seconds);
  const Ending ending = process.wait(1);
  ran.well = ending.well();
  if (ending.timed_out) ran.output += "\nIt takes more than " + std::to_string(kCpuSeconds) + " seconds.\n";
  if (ending.out_of_memory) ran.output += "\nIt takes too much memory.\n";
  return ran;
}

ExerciseResult PublicChecks::check_exercise(const Exercise& exercise, const Submission& submission,
                                            const fs::path& job) const {
  ExerciseResult result = describe(exercise);
  result.max_points = 0;
  const auto file = submission.files.find(exercise.file);
  if (!submission.problem.empty() || file == submission.files.end() || !file->second.problem.empty()) {
    result.status = Status::missing;
    result.feedback = !submission.problem.empty()      ? submission.problem
                      : file == submission.files.end() ? sentence_for(Status::missing)
                                                       : file->second.problem;
    return result;
  }
  const Compiled compiled = compiler_.compile(exercise, file->second.text,
                                              kit_.new_job(job.filename() / exercise.id), kCompilerSeconds);
  result.compiler_messages = compiled.messages;
  if (compiled.object.empty()) {
    result.status = Status::does_not_compile;
    result.feedback = sentence_for(Status::does_not_compile);
    return result;
  }
  const Ran ran = run(exercise, job);
  result.cases = checks_in(ran.output, ran.well);
  result.status = overall_status(result.cases);
  return result;
}

SubmissionResult PublicChecks::check(const Course& course, const Submission& submission,
                                     const Grading::AfterEach& after_each) const {
  SubmissionResult result;
  result.name = submission.name;
  result.isolation = isolation_;
  const fs::path job = kit_.new_job("submission-" + submission.name);
  for (const Exercise& exercise : course.exercises) {
    if (exercise.role != Role::assigned && exercise.role != Role::optional) continue;
    result.exercises.push_back(check_exercise(exercise, submission, job));
    after_each(result);
  }
  std::error_code ignored;
  fs::remove_all(job, ignored);
  return result;
}

}  // namespace grader::tool

// STAFF ONLY. hairchecks FOLDER [--course FILE] [--cache DIR]: does the work of `hairgrade gradescope` before
// the deadline. Each file is compiled as in grading, with the same messages, and its public checks run in a
// sandbox with the student's own prerequisites, as at home. They give no points; the student's process itself
// reports which check passed. It needs no secret and no reference, and links neither. Exit codes are
// hairgrade's.
#include <locale.h>
#include <signal.h>
#include <sodium.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/course/input.h"
#include "grader/grading/exercise_grading.h"
#include "grader/grading/grading.h"
#include "grader/grading/isolation_here.h"
#include "grader/intake/archives/sandboxed_archive.h"
#include "grader/intake/read_submissions.h"
#include "grader/sandbox/inherited.h"
#include "grader/sandbox/sandboxed_process.h"
#include "grader/sandbox/system_mounts.h"
#include "grader/tool/gradescope_hand_in.h"
#include "hair/io/files/finish_output.h"

namespace {

namespace fs = std::filesystem;
using namespace grader;

constexpr double kCompilerSeconds = 20;  // is twice its share in grading, since it is early
constexpr int kCpuSeconds = 20;          // right programs take one or two
constexpr std::size_t kMostSaid = 64 << 10;
constexpr std::size_t kMostOfOne = 3000;  // bounds a check's output
constexpr const char* kPrlimit = "/usr/bin/prlimit";

std::string beginning(const std::string& text) {
  return text.size() <= kMostOfOne ? text : text.substr(0, kMostOfOne) + "\n...";
}

CaseResult category(const std::string& name, Status status, const std::string& says) {
  return {.name = name, .status = status, .feedback = beginning(says)};
}

// Returns the checks of a program's output, each a category without points; and one about its end if no check
// reports it.
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

// Compiles a hand-in's files, and runs the programs of HAIR_PUBLIC_CHECKS, one for each exercise, which look
// for objects in /objects. Keeps a reference.
class PublicChecks {
 public:
  PublicChecks(const Compiler& compiler, Isolation isolation)
      : compiler_(compiler),
        kit_(compiler.toolchain().kit()),
        staged_(kit_.new_job("checks")),
        isolation_(isolation) {
    // A package brings the handout's data; otherwise the build has made it.
    const fs::path packed = fs::path(HAIR_SOURCE_DIR) / "handout/check/golden";
    fs::copy(HAIR_PUBLIC_CHECKS, staged_ / "programs", fs::copy_options::recursive);
    fs::copy(fs::exists(packed) ? packed : fs::path(HAIR_GOLDEN_DIR), staged_ / "golden",
             fs::copy_options::recursive);
    for (const auto& entry : fs::recursive_directory_iterator(staged_))
      fs::permissions(entry.path(), fs::perms(0755));
  }

  SubmissionResult check(const Course& course, const Submission& submission,
                         const Grading::AfterEach& after_each) const {
    SubmissionResult result{.name = submission.name, .isolation = isolation_};
    const fs::path job = kit_.new_job("submission-" + submission.name);
    for (const Exercise& exercise : course.exercises) {
      if (!is_asked_for(exercise.role)) continue;
      result.exercises.push_back(check_exercise(exercise, submission, job));
      after_each(result);
    }
    std::error_code ignored;
    fs::remove_all(job, ignored);
    return result;
  }

 private:
  struct Ran {
    bool well = false;
    std::string output;
  };

  Ran run(const Exercise& exercise, const fs::path& job) const {
    const fs::path program = staged_ / "programs" / exercise.id;
    Sandbox sandbox;
    sandbox.isolation = isolation_;
    sandbox.roots = kit_.roots();
    sandbox.mounts = library_mounts(isolation_, {program, kPrlimit});
    sandbox.mounts.push_back({kPrlimit, kPrlimit});
    sandbox.mounts.push_back({program, "/check"});
    sandbox.mounts.push_back({staged_ / "golden", HAIR_GOLDEN_DIR});
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
    SandboxedProcess process(sandbox, with_inner_limits(sandbox.limits, {"/check", "--gtest_color=no"}), -1,
                             -1, output.write_end.get());
    output.write_end.close();
    Ran ran;
    ran.output = read_both_ends(output.read_end, kMostSaid, sandbox.limits.wall_seconds);
    const Ending ending = process.wait(1);
    ran.well = ending.well();
    if (ending.timed_out) ran.output += "\nIt takes more than " + std::to_string(kCpuSeconds) + " seconds.\n";
    if (ending.out_of_memory) ran.output += "\nIt takes too much memory.\n";
    return ran;
  }

  ExerciseResult check_exercise(const Exercise& exercise, const Submission& submission,
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

  const Compiler& compiler_;
  const StagedKit& kit_;
  fs::path staged_;
  Isolation isolation_;
};

struct Options {
  fs::path folder, cache = "/var/cache/hairchecks";
  std::optional<fs::path> course;
};

void check(const Options& options) {
  const Course course = read_course(HAIR_EXERCISES_JSON, options.course);
  const GradescopeResults results(options.folder, course, {.public_checks = true});
  try {
    const StagedKit kit(HAIR_KIT_DIR, course);
    const Isolation isolation = isolation_here(kit, {});
    const SandboxedReader reader(HAIR_READER, isolation);
    const Intake intake = read_hand_in(options.folder / "submission", "hand-in", course, reader.opener());
    for (const std::string& notice : intake.notices) std::cerr << "hairchecks: " << notice << "\n";
    const Compiler compiler(kit, options.cache, isolation);
    const PublicChecks checks(compiler, isolation);
    checks.check(course, intake.submissions.front(),
                 [&](const SubmissionResult& so_far) { results.write(so_far); });
  } catch (const std::exception&) {
    results.could_not_grade();
    throw;
  }
}

int run_checks(int argc, char* argv[]) {
  setlocale(LC_CTYPE, "C.UTF-8");
  signal(SIGPIPE, SIG_IGN);
  if (sodium_init() < 0) {
    std::cerr << "hairchecks: no source of random numbers\n";
    return 1;
  }
  CLI::App app("hairchecks: compiles a hand-in as grading does, and runs the public checks");
  Options options;
  app.add_option("FOLDER", options.folder, "The folder with submission/ and results/")->required();
  app.add_option("--course", options.course, "The course file");
  app.add_option("--cache", options.cache, "A folder for compiled objects");
  try {
    app.parse(argc, argv);
    check(options);
    return 0;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "hairchecks: " << error.what() << "; see hairchecks --help\n";
    return 2;
  } catch (const BadInput& error) {
    std::cerr << "hairchecks: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "hairchecks: " << error.what() << "\n";
    return 1;
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  hair::begin_output();
  set_what_is_inherited(argv);
  return hair::finish_output("hairchecks", run_checks(argc, argv));
}

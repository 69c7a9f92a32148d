// STAFF ONLY. hairchecks FOLDER [--course FILE] [--cache DIR]: does the work of `hairgrade gradescope` before
// the deadline. It compiles a hand-in as grading does and runs the public checks, which give no points. It
// needs no secret and no reference, and links neither. Exit codes are hairgrade's.
#include <locale.h>
#include <signal.h>
#include <sodium.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "grader/course/input.h"
#include "grader/grading/isolation_here.h"
#include "grader/intake/archives/sandboxed_archive.h"
#include "grader/intake/read_submissions.h"
#include "grader/sandbox/inherited.h"
#include "grader/tool/gradescope_hand_in.h"
#include "grader/tool/public_checks.h"
#include "hair/io/files/finish_output.h"

namespace {

namespace fs = std::filesystem;
using namespace grader;

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
    // A package brings the handout's data; otherwise the build has made it.
    const fs::path packed = fs::path(HAIR_SOURCE_DIR) / "handout/check/golden";
    const PublicChecks checks(compiler, HAIR_PUBLIC_CHECKS,
                              fs::exists(packed) ? packed : fs::path(HAIR_GOLDEN_DIR), HAIR_GOLDEN_DIR,
                              isolation);
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

// STAFF ONLY. Tests that the public checks find what the hidden ones find: a sample that loses points in an
// exercise fails that exercise's public checks (handout/exercises/<ID>/check.cpp), and one with full points
// passes them. So do the wrong programs that are made of the reference: the reference's tests need not repeat
// these checks. The environment's HAIR_EXERCISE names the exercise, and HAIR_SAMPLE a single sample.
// HAIR_TOLD names a folder that keeps the checks' output for each program that fails them.
//
// A sample's file is compiled and linked as for grading, in a sandbox, and the public checks run with it in
// another. Students' checks have sanitizers, too, and find more memory errors. Compiled files are kept.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "grader/compile/compiler.h"
#include "grader/samples/sample.h"
#include "grader/samples/solution_files.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "grader/sandbox/sandboxed_process.h"
#include "grader/sandbox/system_mounts.h"
#include "grader/tests/mutants_found.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT;

// Lists the class's files of the exercise.
std::vector<SampleProgram> class_programs(const Exercise& exercise) {
  const std::string only = environment("HAIR_SAMPLE", "");
  return programs_of(exercise, kProject, [&](const Sample& sample, const std::string& status) {
    return (status == "passed" || runs_and_loses_points(status)) && (only.empty() || sample.name == only);
  });
}

struct Checked {
  bool ran = false, passed = false;
  std::string output;  // is set if it did not pass
};

class PublicChecks : public testing::Test {
 protected:
  const Course course_ = read_course(kProject / "handout/exercises.json");
  const std::string id_ = environment("HAIR_EXERCISE", "");
  const StagedKit kit_{HAIR_KIT_DIR, course_};
  // If the class or mutants were graded here, their caches have the same files.
  const Compiler compiler_{kit_, fs::path(HAIR_GRADED) / "class-cache", isolation_for_tests()};
  const Compiler mutants_{kit_, fs::path(HAIR_GRADED) / "mutants", isolation_for_tests()};
  // This is a copy, since the sandbox's user may not read the project's folder.
  const fs::path checks_ = kit_.new_job("checks");

  void SetUp() override {
    ASSERT_NE(course_.find(id_), nullptr) << "HAIR_EXERCISE must name an exercise; it is \"" << id_ << "\"";
    fs::copy_file(fs::path(HAIR_PUBLIC_CHECKS) / id_, checks_ / "program");
    fs::copy(HAIR_GOLDEN_DIR, checks_ / "golden");
  }

  Checked check(const Compiler& compiler, const std::string& name, const std::string& source) const {
    const fs::path job = kit_.new_job(name);
    const Exercise& exercise = *course_.find(id_);
    const Compiled compiled = compiler.compile(exercise, source, job, 600);
    if (compiled.object.empty()) return {false, false, compiled.log};
    Sandbox sandbox;
    sandbox.isolation = isolation_for_tests();
    sandbox.roots = kit_.roots();
    sandbox.mounts = library_mounts(sandbox.isolation, {});
    sandbox.mounts.push_back({"/usr/bin/prlimit", "/usr/bin/prlimit"});
    sandbox.mounts.push_back({checks_ / "program", "/check"});
    sandbox.mounts.push_back({checks_ / "golden", HAIR_GOLDEN_DIR});
    sandbox.mounts.push_back({compiled.object, "/objects/" + id_ + ".so"});
    for (const std::string& prerequisite : exercise.prerequisites)
      sandbox.mounts.push_back(
          {kit_.folder() / "lib" / (prerequisite + ".so"), "/objects/" + prerequisite + ".so"});
    sandbox.syscalls = Syscalls::toolchain;  // prlimit starts it
    sandbox.limits.cpu_seconds = 40;         // right programs take one or two
    sandbox.limits.wall_seconds = 3600;
    const fs::path log = job / "log";
    const Descriptor output(open(log.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    SandboxedProcess process(sandbox, with_inner_limits(sandbox.limits, {"/check"}), -1, -1, output.get());
    const Ending ending = process.wait(sandbox.limits.wall_seconds);
    const std::string told = ending.well() ? "" : hair::bytes_of(log).substr(0, 4000);
    if (const std::string folder = environment("HAIR_TOLD", ""); !folder.empty() && !ending.well())
      std::ofstream(fs::path(folder) / (id_ + "-" + name + ".txt")) << told;
    return {true, ending.well(), told};
  }
};

TEST_F(PublicChecks, FailWhereTheHiddenOnesTakePointsAndNowhereElse) {
  const std::vector<SampleProgram> programs = class_programs(*course_.find(id_));
  std::vector<Checked> found(programs.size());
  side_by_side(programs.size(),
               [&](std::size_t i) { found[i] = check(compiler_, programs[i].name, programs[i].source); });

  int right = 0, wrong = 0, caught = 0;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const SampleProgram& program = programs[i];
    ASSERT_TRUE(found[i].ran) << program.name << " does not compile:\n" << found[i].output;
    (program.right ? right : wrong) += 1;
    caught += !found[i].passed;
    EXPECT_EQ(found[i].passed, program.right)
        << program.name
        << (program.right ? " is right, and fails the public checks:\n" + found[i].output
                          : " loses points, and passes the public checks. Let them ask for it");
  }
  if (environment("HAIR_SAMPLE", "").empty()) {
    EXPECT_GE(right, 2) << "the reference, and another";
    EXPECT_GE(wrong, 5);
  }
  std::printf("%s: public checks catch %d of %d wrong samples; %d are right\n", id_.c_str(), caught, wrong,
              right);
}

TEST_F(PublicChecks, FailForWrongProgramsThatAreMadeOfTheReference) {
  expect_mutants_found(
      *course_.find(id_),
      [&](const std::string& name, const std::string& source) {
        const Checked found = check(mutants_, name, source);
        if (!found.ran) return Judged{Judgement::does_not_compile};
        return Judged{found.passed ? Judgement::gets_all : Judgement::loses_points};
      },
      "Let the public checks ask for it");
}

}  // namespace
}  // namespace grader

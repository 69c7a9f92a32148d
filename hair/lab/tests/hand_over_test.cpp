// hairlab hands over to its studies, which are a program of their own beside it.
#include <gtest/gtest.h>

#include <chrono>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

// hairlab alone in a folder.
class HandOver : public testing::Test {
 protected:
  HandOver() { fs::copy_file(HAIRLAB, hairlab_); }

  // A program in the place of the studies, which says what it is given.
  void make_studies() const {
    folder_.write("hairlab-study", "#!/bin/sh\necho \"$@\"\necho moved >&2\nexit 130\n");
    fs::permissions(studies_, fs::perms::owner_all);
  }

  void expect_asks_for_a_build(const ProgramRun& run, const std::string& what) const {
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.output, "");
    EXPECT_EQ(run.errors, "hairlab: study is in a program of its own, which is " + what +
                              "; build it with: cmake --build '" + HAIR_BUILD_DIR +
                              "' --target hairlab_studies --parallel 4\n");
  }

  TestFolder folder_;
  const fs::path hairlab_ = folder_ / "hairlab", studies_ = folder_ / "hairlab-study";
};

TEST_F(HandOver, ListsAllCommands) {
  const ProgramRun run = run_hairlab({"--help"}, {.program = hairlab_.string()});
  EXPECT_EQ(run.code, 0);
  for (const char* command :
       {"run", "scenes", "info", "convert", "groom", "solver", "stability", "study", "validate"})
    EXPECT_TRUE(has(run.output, "\n  " + std::string(command) + " ")) << command << "\n" << run.output;
}

TEST_F(HandOver, SaysHowToBuildStudiesThatAreMissing) {
  expect_asks_for_a_build(run_hairlab({"study", "--help"}, {.program = hairlab_.string()}), "not built yet");
}

TEST_F(HandOver, RefusesStudiesThatAreOlderThanItself) {
  make_studies();
  fs::last_write_time(studies_, fs::last_write_time(hairlab_) - std::chrono::milliseconds(10));
  expect_asks_for_a_build(run_hairlab({"study", "--help"}, {.program = hairlab_.string()}),
                          "older than hairlab");
}

TEST_F(HandOver, PassesArgumentsOutputAndExitCodeThrough) {
  make_studies();
  for (const std::string command : {"solver", "stability", "study", "validate"}) {
    const ProgramRun run =
        run_hairlab({command, "run", "--help", "--out", "a b"}, {.program = hairlab_.string()});
    EXPECT_EQ(run.code, 130);
    EXPECT_EQ(run.output, command + " run --help --out a b\n");
    EXPECT_EQ(run.errors, "moved\n");
  }
}

// By another name, too: the studies lie beside the program, not beside its name.
TEST_F(HandOver, FindsStudiesThroughALink) {
  make_studies();
  fs::create_directory(folder_ / "bin");
  fs::create_symlink(hairlab_, folder_ / "bin/lab");
  EXPECT_EQ(run_hairlab({"solver"}, {.program = (folder_ / "bin/lab").string()}).code, 130);
}

TEST_F(HandOver, SaysThatStudiesDoNotRun) {
  make_studies();
  fs::permissions(studies_, fs::perms::owner_read);
  const ProgramRun run = run_hairlab({"study"}, {.program = hairlab_.string()});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.errors,
            "hairlab: " + fs::canonical(studies_).string() + " does not run (Permission denied)\n");
}

}  // namespace
}  // namespace hair

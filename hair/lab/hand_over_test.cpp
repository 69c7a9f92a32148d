// hairlab hands over to its studies and to its groom reader, which are separate programs in its folder.
#include <gtest/gtest.h>

#include <chrono>

#include "hair/lab/test_run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

// hairlab alone in a folder.
class HandOver : public testing::Test {
 protected:
  HandOver() { fs::copy_file(HAIRLAB, hairlab_); }

  // Writes a program that replaces another one and prints its arguments.
  void make_program(const fs::path& file) const {
    folder_.write(file.filename(), "#!/bin/sh\necho \"$@\"\necho moved >&2\nexit 130\n");
    fs::permissions(file, fs::perms::owner_all);
  }

  TestFolder folder_;
  const fs::path hairlab_ = folder_ / "hairlab", studies_ = folder_ / "hairlab-study";
};

TEST_F(HandOver, ListsAllCommands) {
  const ProgramRun run = run_hairlab({"--help"}, {.program = hairlab_.string()});
  EXPECT_EQ(run.code, 0);
  for (const char* command : {"run", "scenes", "live", "info", "convert", "groom", "phase", "solver",
                              "stability", "study", "validate"})
    EXPECT_TRUE(says(run.output, "\n  " + std::string(command) + " ")) << command << "\n" << run.output;
}

TEST_F(HandOver, SaysHowToBuildStudiesThatAreMissingOrOlderThanItself) {
  const auto expect_asks_for_a_build = [&](const std::string& what) {
    const ProgramRun run = run_hairlab({"study", "--help"}, {.program = hairlab_.string()});
    expect_refused(run, 2, "");
    EXPECT_EQ(run.errors, "hairlab: study is in a program of its own, which is " + what +
                              "; build it with: cmake --build '" + HAIR_BUILD_DIR +
                              "' --target hairlab_studies --parallel 4\n");
  };
  expect_asks_for_a_build("not built yet");
  make_program(studies_);
  fs::last_write_time(studies_, fs::last_write_time(hairlab_) - std::chrono::milliseconds(10));
  expect_asks_for_a_build("older than hairlab");
}

TEST_F(HandOver, PassesArgumentsOutputAndExitCodeThrough) {
  make_program(studies_);
  for (const std::string command : {"solver", "stability", "study", "validate"}) {
    const ProgramRun run =
        run_hairlab({command, "run", "--help", "--out", "a b"}, {.program = hairlab_.string()});
    EXPECT_EQ(run.code, 130);
    EXPECT_EQ(run.output, command + " run --help --out a b\n");
    EXPECT_EQ(run.errors, "moved\n");
  }
}

// The groom program runs a scene with a groom's file; hairlab itself runs the scene without that file.
TEST_F(HandOver, NamesWhatReadsTheGroomOfAScene) {
  const std::string scene = folder_.write(
      "own.json",
      R"({"shows": "a groom", "frames": 1, "hair": [{"groom": {"file": "a.hair", "scale": 1}}]})");
  const std::string asks =
      "hairlab: the reader of " + (folder_ / "a.hair").string() +
      " is in a program of its own, which is not built yet; build it with: cmake --build '" + HAIR_BUILD_DIR +
      "' --target hairlab_grooms --parallel 4\n";
  const ProgramRun missing = run_hairlab({"run", scene, "--explain"}, {.program = hairlab_.string()});
  EXPECT_EQ(missing.code, 2);
  EXPECT_EQ(missing.errors, asks);
  make_program(folder_ / "hairlab-groom");
  const ProgramRun run = run_hairlab({"run", scene, "--explain"}, {.program = hairlab_.string()});
  EXPECT_EQ(run.code, 130);
  EXPECT_EQ(run.output, "run " + scene + " --explain\n");
}

// The studies are found by the program's own folder, not by that of its link.
TEST_F(HandOver, FindsStudiesThroughALinkAndSaysThatTheyDoNotRun) {
  make_program(studies_);
  fs::create_symlink(hairlab_, folder_ / "lab");
  EXPECT_EQ(run_hairlab({"solver"}, {.program = (folder_ / "lab").string()}).code, 130);
  fs::permissions(studies_, fs::perms::owner_read);
  const ProgramRun run = run_hairlab({"study"}, {.program = hairlab_.string()});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.errors,
            "hairlab: " + fs::canonical(studies_).string() + " does not run (Permission denied)\n");
}

}  // namespace
}  // namespace hair

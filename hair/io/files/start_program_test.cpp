#include "hair/io/files/start_program.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <system_error>

#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace hair {
namespace {

std::vector<std::string> shell(const std::string& command) {
  return {"/bin/sh", "-c", command};
}

TEST(StartProgram, GivesItsExitCodeOrNothingIfASignalEndedIt) {
  EXPECT_EQ(exit_code_of(start_program({.words = shell("exit 7")})), 7);
  EXPECT_EQ(exit_code_of(start_program({.words = shell("kill -9 $$")})), std::nullopt);
  EXPECT_THROW(start_program({.words = {"/no/such/program"}}), std::system_error);
}

TEST(StartProgram, StreamsFolderAndEnvironmentAreAsWanted) {
  const TemporaryFolder folder("start-program");
  const std::filesystem::path in = folder.path() / "in", out = folder.path() / "out",
                              errors = folder.path() / "errors";
  setenv("HAIR_OURS", "ours", 1);
  setenv("HAIR_THEIRS", "ours", 1);
  EXPECT_EQ(exit_code_of(start_program({.words = shell("echo 'a line' >in"), .folder = folder.path()})), 0);
  EXPECT_EQ(
      exit_code_of(start_program({.words = shell("cat; pwd; echo $HAIR_OURS $HAIR_THEIRS; echo wrong >&2"),
                                  .input = in,
                                  .output = out,
                                  .errors = errors,
                                  .folder = folder.path(),
                                  .environment = {"HAIR_THEIRS=theirs"}})),
      0);
  EXPECT_EQ(bytes_of(out), "a line\n" + folder.path().string() + "\nours theirs\n");
  EXPECT_EQ(bytes_of(errors), "wrong\n");
}

TEST(StartProgram, ItMayLeadAGroup) {
  const TemporaryFolder folder("start-program");
  const std::filesystem::path out = folder.path() / "out";
  for (const bool leads : {false, true}) {
    const pid_t process =
        start_program({.words = shell("ps -o pgid= -p $$ | tr -d ' '"), .output = out, .leads_group = leads});
    EXPECT_EQ(exit_code_of(process), 0);
    EXPECT_EQ(bytes_of(out) == std::to_string(process) + "\n", leads);
  }
}

TEST(StartProgram, ItIsWaitedForUntilSomethingHappensOrItEnds) {
  const TemporaryFolder folder("start-program");
  const auto is_there = [&] { return std::filesystem::exists(folder.path() / "file"); };
  const pid_t ends = start_program({.words = shell("exit 7")});
  EXPECT_FALSE(wait_until(is_there, ends));
  EXPECT_EQ(exit_code_of(ends), 7);
  const pid_t goes_on =
      start_program({.words = shell("sleep 0.1; : >file; exec sleep 1000"), .folder = folder.path()});
  EXPECT_TRUE(wait_until(is_there, goes_on));
  kill(goes_on, SIGKILL);
  EXPECT_EQ(exit_code_of(goes_on), std::nullopt);
}

}  // namespace
}  // namespace hair

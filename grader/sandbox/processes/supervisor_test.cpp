// STAFF ONLY. Tests that the supervisor ends the right processes in time and leaves none.
#include "grader/sandbox/processes/supervisor.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <fstream>
#include <string>
#include <vector>

#include "grader/sandbox/processes/launch.h"
#include "grader/sandbox/sandboxed_for_tests.h"
#include "hair/io/files/read_file.h"
#include "solver/test_refusal.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;
using tests::says;

class SupervisorTest : public SandboxTest {};
INSTANTIATE_TEST_SUITE_P(Kinds, SupervisorTest, testing::Values(Isolation::namespaces, Isolation::container),
                         [](const auto& kind) { return to_string(kind.param); });

class ContainerSupervisorTest : public ContainerTest {};

// A child of the run with its own session is ended, too, and no dead process stays.
TEST_F(ContainerSupervisorTest, EndsWhatItsRunsLeave) {
  sandbox_.syscalls.reset();
  const pid_t left = std::atoi(shell("setsid sleep 1000 > /dev/null & echo $!").output.c_str());
  ASSERT_GT(left, 1);
  EXPECT_EQ(kill(left, 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

// True if the process is gone, or dead and its new parent has not waited for it yet.
bool is_dead(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  return !(file >> number >> name >> state) || state == "Z" || state == "X";
}

bool dies(pid_t process) {
  for (int look = 0; look < 6'000 && !is_dead(process); ++look) usleep(10'000);
  return is_dead(process);
}

// Runs without a control group, which would end all processes in it.
TEST_P(SupervisorTest, EndsWhatAKilledSupervisorLeaves) {
  Pipe output = make_pipe();
  SandboxedProcess process(sandbox_, {"/usr/bin/bash", "-c", "sleep 1000 & echo inside; wait"}, -1, -1,
                           output.write_end.get(), [](Launch& launch, RunLimits&) { launch.joins.clear(); });
  char letter;
  ASSERT_EQ(read(output.read_end.get(), &letter, 1), 1);
  const std::vector<pid_t> all = descendants(getpid());
  ASSERT_GE(all.size(), 3U) << "the supervisor, the shell, and what it started";
  kill(all.front(), SIGKILL);
  EXPECT_EQ(process.wait(sandbox_.limits.wall_seconds).signal, SIGKILL);
  for (const pid_t one : all) EXPECT_TRUE(dies(one)) << one;
}

// A child of the test becomes a grader, and is killed in the middle of a run.
TEST_P(SupervisorTest, IsEndedWithAKilledGrader) {
  Pipe said = make_pipe();
  const pid_t grader = fork();
  if (grader == 0) {
    const SandboxedProcess process(sandbox_, {"/usr/bin/bash", "-c", "sleep 1000 & echo inside; wait"}, -1,
                                   -1, said.write_end.get());
    for (;;) pause();
  }
  char letter;
  ASSERT_EQ(read(said.read_end.get(), &letter, 1), 1);
  const std::vector<pid_t> all = descendants(grader);
  EXPECT_GE(all.size(), 3U);
  kill(grader, SIGKILL);
  waitpid(grader, nullptr, 0);
  for (const pid_t one : all) EXPECT_TRUE(dies(one)) << one;
}

TEST_F(ContainerSupervisorTest, BoundsTheMemoryOfAllProcessesTogether) {
  sandbox_.limits.memory_bytes = std::size_t{512} << 20;
  sandbox_.limits.processes = 16;
  const Limits each = sandbox_.limits;
  sandbox_.limits.memory_bytes = std::size_t{100} << 20;
  const std::string one = "printf -v x '%*s' 60000000 ''; sleep 1000";
  Pipe silence = make_pipe();
  SandboxedProcess process(
      sandbox_, with_inner_limits(each, {"/usr/bin/bash", "-c", "(" + one + ") & (" + one + ") & wait"}), -1,
      -1, silence.write_end.get());
  EXPECT_TRUE(process.wait(sandbox_.limits.wall_seconds).out_of_memory);
}

TEST_P(SupervisorTest, ContainsAForkBomb) {
  sandbox_.limits.processes = 16;
  sandbox_.limits.cpu_seconds = 1;
  sandbox_.limits.wall_seconds = 2;
  const std::string bomb = "bomb_" + std::to_string(getpid());
  const Said run = shell(bomb + "() { " + bomb + " | " + bomb + " & }; " + bomb + "; sleep infinity");
  EXPECT_TRUE(says(run.output, "fork: "));
  const auto lives = [&] {
    for (const auto& process : fs::directory_iterator("/proc"))
      if (std::isdigit(process.path().filename().c_str()[0]) != 0 &&
          hair::bytes_of(process.path() / "cmdline").find(bomb) != std::string::npos)
        return true;
    return false;
  };
  for (int look = 0; look < 60'000 && lives(); ++look) usleep(10'000);
  EXPECT_FALSE(lives());
}

}  // namespace
}  // namespace grader::sandbox

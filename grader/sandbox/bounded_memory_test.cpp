// STAFF ONLY. Tests a container whose memory is smaller than a run's limit, where no control group of its own
// bounds the run: the run ends as out of memory, and the grader lives.
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "grader/sandbox/processes/control_group.h"
#include "grader/sandbox/processes/launch.h"
#include "grader/sandbox/processes/own_groups.h"
#include "grader/sandbox/processes/supervisor.h"
#include "grader/sandbox/sandboxed_for_tests.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

// The groups can be read, but none can be made below them, as in a container.
bool shut_groups() {
  if (unshare(CLONE_NEWNS) != 0 || mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0)
    return false;
  for (const char* controller : {"", "memory", "pids"})
    if (const std::vector<fs::path> groups = own_groups(controller); !groups.empty())
      if (mount(nullptr, groups.back().c_str(), nullptr, MS_REMOUNT | MS_BIND | MS_RDONLY, nullptr) != 0)
        return false;
  return !ControlGroup::create(kMegabyte, 8);
}

struct Found {
  bool tried = false, out_of_memory = false, well = false;
  long ended_by_kernel = 0;
};

// Runs a process that takes this much in a group of 400 MB. Its own limit is a gigabyte.
Found run_in_a_small_container(std::size_t takes, const SandboxedProcess::LeaveOut& leave_out) {
  const StagingFolder folder;
  Sandbox sandbox = sandbox_of_probe(Isolation::container, folder);
  sandbox.limits.memory_bytes = 1024 * kMegabyte;

  const std::optional<ControlGroup> container = ControlGroup::create(400 * kMegabyte, 1000);
  if (!container || !container->bounds_memory()) return {};
  Pipe told = make_pipe();
  const pid_t child = fork();
  if (child == 0) {
    for (const fs::path& file : container->join_files()) std::ofstream(file) << 0 << std::flush;
    if (!shut_groups()) _exit(1);
    SandboxedProcess run(sandbox, {"/probe", "memory", std::to_string(takes)}, -1, -1, -1, leave_out);
    const Ending ending = run.wait(sandbox.limits.wall_seconds);
    const Found found{true, ending.out_of_memory, ending.code == 1 && ending.signal == 0, ended_for_memory()};
    _exit(write(told.write_end.get(), &found, sizeof found) == sizeof found ? 0 : 1);
  }
  told.write_end.close();
  Found found;
  if (read(told.read_end.get(), &found, sizeof found) != sizeof found) found = {};
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_FALSE(WIFSIGNALED(status)) << "the kernel has ended the grader";
  return found;
}

bool can_shut_groups() {
  const pid_t child = fork();
  if (child == 0) _exit(shut_groups() ? 0 : 1);
  int status = 1;
  waitpid(child, &status, 0);
  return status == 0;
}

bool memory_can_be_bounded() {
  const std::optional<ControlGroup> group = ControlGroup::create(400 * kMegabyte, 8);
  return group && group->bounds_memory();
}

class BoundedMemory : public testing::Test {
  void SetUp() override {
    if (const std::string why = why_not(Isolation::container); !why.empty()) GTEST_SKIP() << why;
    if (!memory_can_be_bounded() || !can_shut_groups())
      GTEST_SKIP() << "this test can't make a small container in a container";
  }
};

TEST_F(BoundedMemory, TheSupervisorEndsARunBeforeTheKernelDoes) {
  const Found found = run_in_a_small_container(600 * kMegabyte, [](Launch&, RunLimits&) {});
  ASSERT_TRUE(found.tried);
  EXPECT_TRUE(found.out_of_memory);
  EXPECT_EQ(found.ended_by_kernel, 0);
}

TEST_F(BoundedMemory, TheKernelEndsTheRunAndItIsSaid) {
  const Found found = run_in_a_small_container(600 * kMegabyte,
                                               [](Launch&, RunLimits& limits) { limits.resident_bytes = 0; });
  ASSERT_TRUE(found.tried);
  EXPECT_TRUE(found.out_of_memory);
  EXPECT_GT(found.ended_by_kernel, 0);
}

TEST_F(BoundedMemory, ARunThatFitsIsLeftAlone) {
  const Found found = run_in_a_small_container(100 * kMegabyte, [](Launch&, RunLimits&) {});
  ASSERT_TRUE(found.tried);
  EXPECT_FALSE(found.out_of_memory);
  EXPECT_TRUE(found.well);
}

}  // namespace
}  // namespace grader::sandbox

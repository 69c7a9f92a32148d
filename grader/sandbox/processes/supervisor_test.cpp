// STAFF ONLY. Tests that the supervisor ends the right processes in time and leaves none, the limits of
// control groups, threads on processors of their own, and a container whose memory is smaller than a run's
// limit.
#include "grader/sandbox/processes/supervisor.h"

#include <gtest/gtest.h>

#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "grader/sandbox/processes/control_groups.h"
#include "grader/sandbox/processes/processors.h"
#include "grader/sandbox/sandboxed_for_tests.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
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

cpu_set_t allowed() {
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof set, &set);
  return set;
}

class OwnGroups : public testing::Test {
 protected:
  OwnGroups() : temporary_("own-groups"), root_(temporary_.path()) {}

  void write(const std::string& path, const std::string& text) const {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  hair::TemporaryFolder temporary_;
  fs::path root_;
};

constexpr const char* kVersion2 = "cgroup2 /sys/fs/cgroup cgroup2 ro,nosuid 0 0\n";
constexpr const char* kVersion1 =
    "cgroup /sys/fs/cgroup/cpu,cpuacct cgroup ro,nosuid,cpu,cpuacct 0 0\n"
    "cgroup /sys/fs/cgroup/memory cgroup ro,nosuid,memory 0 0\n";

TEST_F(OwnGroups, AContainersTopIsItsOwnGroup) {
  write("proc/self/mounts", kVersion2);
  write("proc/self/cgroup", "0::/\n");
  write("sys/fs/cgroup/cpu.max", "50000 100000\n");
  write("sys/fs/cgroup/memory.max", "805306368\n");
  EXPECT_DOUBLE_EQ(usable_processors(root_), 0.5);
  EXPECT_EQ(usable_memory_bytes(root_), 768U << 20);
  EXPECT_EQ(usable_jobs(root_), 1);
}

// Version 1 names the host's folders. A container sees only its own ones.
TEST_F(OwnGroups, PathsOfTheHostLeadNowhere) {
  write("proc/self/mounts", kVersion1);
  write("proc/self/cgroup", "4:memory:/docker/1f2e\n1:cpu,cpuacct:/docker/1f2e\n0::/docker/1f2e\n");
  write("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "25000\n");
  write("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "50000\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "1000000000\n");
  EXPECT_DOUBLE_EQ(usable_processors(root_), 0.5);
  EXPECT_EQ(usable_memory_bytes(root_), 1'000'000'000U);
}

TEST_F(OwnGroups, TheLeastOfAGroupAndThoseAboveItCounts) {
  write("proc/self/mounts", kVersion2);
  write("proc/self/cgroup", "0::/course/job\n");
  write("sys/fs/cgroup/course/cpu.max", "70000 100000\n");
  write("sys/fs/cgroup/course/memory.max", "900000000\n");
  write("sys/fs/cgroup/course/job/cpu.max", "max 100000\n");
  write("sys/fs/cgroup/course/job/memory.max", "max\n");
  EXPECT_DOUBLE_EQ(usable_processors(root_), 0.7);
  EXPECT_EQ(usable_memory_bytes(root_), 900'000'000U);
  const std::vector<fs::path> groups = own_groups("", root_);
  const fs::path top = root_ / "sys/fs/cgroup";
  EXPECT_EQ(groups, (std::vector<fs::path>{top / "course/job", top / "course", top}));
}

TEST_F(OwnGroups, WithoutALimitAllOfTheMachineCounts) {
  const double processors = usable_processors(root_);  // this root has no /proc
  const std::size_t memory = usable_memory_bytes(root_);
  const cpu_set_t all = allowed();
  EXPECT_EQ(processors, CPU_COUNT(&all));
  write("proc/self/mounts", kVersion1);
  write("proc/self/cgroup", "4:memory:/\n1:cpu,cpuacct:/\n");
  write("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "-1\n");
  write("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "100000\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(usable_processors(root_), processors);
  EXPECT_EQ(usable_memory_bytes(root_), memory);
}

TEST_F(OwnGroups, ProcessesThatTheKernelEndedForMemoryAreCounted) {
  write("two/memory.events", "low 0\noom 5\noom_kill 3\n");
  write("one/memory.oom_control", "oom_kill_disable 0\nunder_oom 0\noom_kill 2\n");
  EXPECT_EQ(ended_for_memory(root_ / "two"), 3);
  EXPECT_EQ(ended_for_memory(root_ / "one"), 2);
  EXPECT_EQ(ended_for_memory(root_ / "none"), 0);
}

TEST(Processors, BindAThreadToOneAsLongAsItHasALease) {
  const cpu_set_t before = allowed();
  Processors processors;
  {
    const Processors::Lease lease(processors);
    const cpu_set_t one = allowed();
    EXPECT_EQ(CPU_COUNT(&one), 1);
    EXPECT_TRUE(CPU_ISSET(sched_getcpu(), &one)) << "it is there already";
  }
  const cpu_set_t after = allowed();
  EXPECT_TRUE(CPU_EQUAL(&before, &after));
}

TEST(Processors, ThreadsHaveTheirOwnAsLongAsThereAreEnough) {
  const cpu_set_t all = allowed();
  if (CPU_COUNT(&all) < 2) GTEST_SKIP() << "this machine has one processor";
  Processors processors;
  const Processors::Lease lease(processors);
  const cpu_set_t mine = allowed();
  for (int time = 0; time < 2; ++time)  // the first lease has ended by the second time
    std::jthread([&] {
      const Processors::Lease its(processors);
      const cpu_set_t other = allowed();
      EXPECT_EQ(CPU_COUNT(&other), 1);
      EXPECT_FALSE(CPU_EQUAL(&mine, &other)) << "two leases at a time have the same processor";
    });
}

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
  const Found found = run_in_a_small_container(600 * kMegabyte, {});
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
  const Found found = run_in_a_small_container(100 * kMegabyte, {});
  ASSERT_TRUE(found.tried);
  EXPECT_FALSE(found.out_of_memory);
  EXPECT_TRUE(found.well);
}

}  // namespace
}  // namespace grader::sandbox

// STAFF ONLY. Tests the limits of control groups on trees of files, as containers show them.
#include "grader/sandbox/processes/own_groups.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <fstream>
#include <string>

#include "hair/io/files/temporary_folder.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

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
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  sched_getaffinity(0, sizeof allowed, &allowed);
  EXPECT_EQ(processors, CPU_COUNT(&allowed));
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

}  // namespace
}  // namespace grader::sandbox

// STAFF ONLY. Tries from inside, with a shell, that a sandbox keeps the process in.
#include "grader/sandbox/sandboxed_process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>

#include "grader/sandbox/processes/supervisor.h"
#include "grader/sandbox/sandboxed_for_tests.h"
#include "hair/io/files/bad_input.h"
#include "solver/test_refusal.h"
#include "solver/timing.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;
using tests::says;

INSTANTIATE_TEST_SUITE_P(Kinds, SandboxTest, testing::Values(Isolation::namespaces, Isolation::container),
                         [](const auto& kind) { return to_string(kind.param); });

class NamespacesTest : public Sandboxed, public testing::Test {
 protected:
  NamespacesTest() : Sandboxed(Isolation::namespaces) {}
  void SetUp() override {
    if (const std::string why = why_not(Isolation::namespaces); !why.empty()) GTEST_SKIP() << why;
  }
};

TEST_P(SandboxTest, RunsAProgramAndSaysHowItEnded) {
  const Said well = shell("echo hello");
  EXPECT_TRUE(well.ending.well());
  EXPECT_EQ(well.output, "hello\n");
  EXPECT_EQ(shell("exit 3").ending.code, 3);
  EXPECT_EQ(shell("kill -SEGV $$").ending.signal, SIGSEGV);
}

TEST_F(NamespacesTest, HoldsNothingButWhatIsMounted) {
  const Said run = shell(
      "shopt -s dotglob; for f in /* /etc/* /home/* /root/* /proc/*; do [ -e \"$f\" ] && echo \"$f\"; done");
  EXPECT_EQ(run.output, "/bin\n/dev\n/etc\n/lib\n/lib64\n/tmp\n/usr\n/etc/alternatives\n");
  EXPECT_EQ(shell("ls -A /usr/include/eigen3").output, "");
  EXPECT_EQ(shell("ls -A /usr/include/nlohmann").output, "");
}

TEST_F(ContainerTest, HoldsNothingButItsMountsAndAnEmptyTmp) {
  EXPECT_EQ(shell("shopt -s dotglob; for f in /* /etc/* /home/* /root/* /proc/*; do [ -e \"$f\" ] && echo "
                  "\"$f\"; done; ls -A /tmp")
                .output,
            "/bin\n/dev\n/lib\n/lib64\n/tmp\n/usr\n");
  EXPECT_EQ(shell("ls /usr/include/eigen3 2>&1 | head -c 10").output, "ls: cannot");
  shell("echo x > /tmp/left");
  EXPECT_EQ(shell("ls -A /tmp").output, "") << "the next run finds nothing of the last one";
}

TEST_F(ContainerTest, GivesEachRunAUserOfItsOwn) {
  const std::string one = shell("id -u; id -g").output, other = shell("id -u; id -g").output;
  EXPECT_NE(one, other);
  EXPECT_GT(std::atoi(one.c_str()), 60'000);
}

TEST_P(SandboxTest, HasNoEnvironmentOfOurs) {
  setenv("STAFF_SECRET", "do not look", 1);
  const std::string environment = shell("export -p; pwd").output;
  unsetenv("STAFF_SECRET");
  EXPECT_FALSE(says(environment, "STAFF_SECRET"));
  EXPECT_FALSE(says(environment, "HOME"));
}

TEST_P(SandboxTest, WritesNowhereButInItsOwnTmp) {
  for (const char* place : {"/x", "/usr/x", "/usr/bin/x", "/etc/x", "/etc/alternatives/x", "/dev/x"})
    EXPECT_FALSE(
        says(shell(std::string("echo x 2>/dev/null > ") + place + " && echo written").output, "written"))
        << place;
  EXPECT_TRUE(says(shell("echo x > /tmp/from-the-sandbox && echo written").output, "written"));
  EXPECT_FALSE(fs::exists("/tmp/from-the-sandbox"));
}

TEST_F(NamespacesTest, ItsTmpHasASize) {
  EXPECT_FALSE(says(shell("printf '%*s' 8000000 '' > /tmp/large && echo written").output, "written"));
}

TEST_F(NamespacesTest, SharesNoNamespaceWithUs) {
  Pipe output = make_pipe();
  SandboxedProcess process(sandbox_, {"/usr/bin/bash", "-c", "echo inside; sleep 1000"}, -1, -1,
                           output.write_end.get());
  char letter;
  ASSERT_EQ(read(output.read_end.get(), &letter, 1), 1);  // it runs inside now
  const fs::path theirs = "/proc/" + std::to_string(descendants(getpid()).back()) + "/ns";
  for (const char* space : {"user", "pid", "net", "mnt", "ipc", "uts", "cgroup"}) {
    const std::string inside = fs::read_symlink(theirs / space);
    EXPECT_TRUE(inside.starts_with(space)) << inside;
    EXPECT_NE(inside, fs::read_symlink(fs::path("/proc/self/ns") / space));
  }
}

TEST_P(SandboxTest, InheritsNoDescriptors) {
  const Descriptor secret(open("/dev/null", O_RDONLY));  // has no close-on-exec
  const Said run =
      shell("for i in $(seq 3 9) $(seq 11 250); do { true <&$i; } 2>/dev/null && echo $i; done; true");
  EXPECT_EQ(run.output, "");  // bash itself uses 10
}

TEST_P(SandboxTest, SeesSleepAndWorkFromOutside) {
  // A slow and busy machine needs more looks.
  const auto is_seen = [](const std::function<bool()>& look) {
    for (int i = 0; i < 200; ++i)
      if (look()) return true;
    return false;
  };
  const auto busy = [](const SandboxedProcess& process) {
    double sum = 0;
    for (const auto& [thread, times] : process.activity().busy) sum += times.computed + times.queued;
    return sum;
  };
  SandboxedProcess sleeper(sandbox_, {"/usr/bin/sleep", "infinity"}, -1, -1, -1);
  EXPECT_TRUE(is_seen([&] {
    const double before = busy(sleeper);
    usleep(300000);
    return sleeper.activity().started && busy(sleeper) < before + 0.01;
  })) << "it sleeps";
  EXPECT_TRUE(sleeper.activity().alive);
  SandboxedProcess worker(sandbox_, {"/usr/bin/bash", "-c", "while :; do :; done"}, -1, -1, -1);
  EXPECT_TRUE(is_seen([&] {
    usleep(100000);
    return worker.activity().cpu_seconds > 0.05;
  })) << "it computes";
  // A program that does not compute waits for a processor if others compute. The kernel counts a wait only at
  // its end.
  const double before = busy(worker);
  const timing::Stopwatch since;
  EXPECT_TRUE(is_seen([&] {
    usleep(500000);
    return busy(worker) - before > 0.9 * since.seconds();
  })) << busy(worker) - before
      << " s of " << since.seconds();
}

TEST_P(SandboxTest, LimitsMemory) {
  const std::string takes = "printf -v x '%*s' 104857600 ''; echo ${#x}";
  sandbox_.limits.memory_bytes = std::size_t{1} << 30;
  EXPECT_EQ(shell(takes).output, "104857600\n");
  sandbox_.limits.memory_bytes = std::size_t{64} << 20;
  EXPECT_FALSE(says(shell(takes).output, "104857600"));
}

// Two layers bound processes: a limit and a control group. Each is tried without the other, and then neither.
TEST_P(SandboxTest, LimitsProcesses) {
  sandbox_.mounts.push_back(mount_of_probe(folder_));
  sandbox_.limits.processes = 16;
  const std::vector<std::string> starts = {"/probe", "fork", "40"};
  const std::string succeeds = "can start 40 processes\n";
  const auto said = [&](const std::vector<std::string>& command, bool in_group) {
    Pipe output = make_pipe();
    SandboxedProcess process(sandbox_, command, -1, -1, output.write_end.get(),
                             [in_group](Launch& launch, RunLimits&) {
                               if (!in_group) launch.joins.clear();
                             });
    output.write_end.close();
    const std::string text = read_all(output.read_end, 1000, sandbox_.limits.wall_seconds);
    process.kill();
    process.wait(sandbox_.limits.wall_seconds);
    return text;
  };
  EXPECT_EQ(said(starts, false), succeeds);
  EXPECT_EQ(said(with_inner_limits(sandbox_.limits, starts), false), "");
  const std::string in_group = said(starts, true);
  if (ControlGroup::create(sandbox_.limits.memory_bytes, sandbox_.limits.processes)) {
    EXPECT_EQ(in_group, "");
  }
}

TEST_P(SandboxTest, LimitsTheSizeOfFiles) {
  fs::create_directory(folder_ / "out");
  share_with_sandbox(folder_ / "out", true);
  sandbox_.mounts.push_back({folder_ / "out", "/out", true});
  sandbox_.limits.file_bytes = 1 << 16;
  shell("printf '%*s' 1000000 '' > /out/large");
  EXPECT_EQ(fs::file_size(folder_ / "out" / "large"), sandbox_.limits.file_bytes);
}

// A child becomes root of a user namespace, as `unshare -Ur` makes it.
TEST(SandboxIdentity, ARootThatCanDropNoRightsIsToldSo) {
  Pipe said = make_pipe();
  const pid_t child = fork();
  if (child == 0) {
    const std::string user = std::to_string(geteuid()), group = std::to_string(getegid());
    std::string why = "no refusal";
    if (unshare(CLONE_NEWUSER) != 0) _exit(77);
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
    try {
      sandbox_identity();
    } catch (const hair::BadInput& error) {
      why = error.what();
    }
    _exit(write(said.write_end.get(), why.data(), why.size()) > 0 ? 0 : 1);
  }
  said.write_end.close();
  const std::string why = read_all(said.read_end, 1000, 100);
  int status = 0;
  waitpid(child, &status, 0);
  if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "this machine makes no user namespaces";
  EXPECT_TRUE(why.starts_with("this root belongs to a user namespace without the user and group 64123"))
      << why;
}

}  // namespace
}  // namespace grader::sandbox

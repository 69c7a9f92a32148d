// STAFF ONLY. Tests that the watchdog ends idle processes of all kinds and leaves busy ones alone, on an idle
// and on a busy machine.
#include "grader/sandbox/watchdog.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <thread>
#include <vector>

#include "grader/sandbox/isolation_for_tests.h"
#include "grader/sandbox/processes/descriptor.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/system_mounts.h"
#include "solver/timing.h"

namespace grader::inline sandbox {
namespace {

// A process never answers, and a watchdog waits for it.
class Waiting {
 public:
  explicit Waiting(const std::vector<std::string>& command, Watchdog::Patience patience,
                   Isolation isolation = isolation_for_tests())
      : process_(sandbox(isolation), command, -1, -1, -1), watchdog_(process_, patience) {}

  // Waits until the patience is used up.
  const Watchdog& wait() {
    EXPECT_FALSE(watchdog_.wait_for(silence_.read_end.get(), POLLIN));
    return watchdog_;
  }

 private:
  static Sandbox sandbox(Isolation isolation) {
    Sandbox sandbox;
    static const StagingFolder folder;
    static const std::vector<Mount> programs = program_mounts({"/usr/bin/bash", "/usr/bin/sleep"});
    sandbox.mounts = programs;
    sandbox.isolation = isolation;
    sandbox.roots = folder.path() / "roots";
    return sandbox;
  }

  Pipe silence_ = make_pipe();
  SandboxedProcess process_;
  Watchdog watchdog_;
};

const std::vector<std::string> kComputes = {"/usr/bin/bash", "-c", "while :; do :; done"};

TEST(Watchdog, EndsWhatSleeps) {
  Waiting sleeper({"/usr/bin/sleep", "1000"}, {.idle_seconds = 0.6, .cpu_seconds = 10});
  const Watchdog& watchdog = sleeper.wait();
  EXPECT_STREQ(watchdog.why(), "asleep");
  EXPECT_GT(watchdog.idle_seconds(), 0.6);
}

// The kernel calls this state D, like a wait for a disk.
TEST(Watchdog, EndsWhatWaitsForAChildThatSharesItsMemory) {
  Waiting waiting({HAIR_IDLER, "vfork"}, {.idle_seconds = 0.6, .cpu_seconds = 10, .wall_seconds = 200},
                  Isolation::none);
  EXPECT_STREQ(waiting.wait().why(), "asleep");
}

TEST(Watchdog, EndsWhatSleepsInShortNaps) {
  Waiting naps({HAIR_IDLER, "naps"}, {.idle_seconds = 0.6, .cpu_seconds = 10, .wall_seconds = 200},
               Isolation::none);
  EXPECT_STREQ(naps.wait().why(), "asleep");
}

TEST(Watchdog, EndsWhatComputesForever) {
  Waiting computing(kComputes, {.idle_seconds = 5, .cpu_seconds = 0.5});
  const Watchdog& watchdog = computing.wait();
  EXPECT_STREQ(watchdog.why(), "out of CPU time");
  EXPECT_GE(watchdog.cpu_seconds(), 0.5);
  EXPECT_LT(watchdog.cpu_seconds(), 1);
}

// All processes of this machine wait for a processor.
class BusyMachine {
 public:
  BusyMachine() {
    for (unsigned i = 0; i < 4 * std::thread::hardware_concurrency(); ++i)
      others_.emplace_back([](const std::stop_token& enough) {
        while (!enough.stop_requested()) {
        }
      });
  }

 private:
  std::vector<std::jthread> others_;
};

// A wait there is not idling.
TEST(Watchdog, LeavesAloneWhatWaitsForABusyMachine) {
  const BusyMachine busy;
  Waiting computing(kComputes, {.idle_seconds = 0.6, .cpu_seconds = 0.4, .wall_seconds = 600});
  const Watchdog& watchdog = computing.wait();
  EXPECT_STREQ(watchdog.why(), "out of CPU time");
  EXPECT_LT(watchdog.idle_seconds(), 0.3);
}

// A process without a sandbox writes to the watchdog's pipe.
class Talking {
 public:
  Talking(const std::vector<std::string>& command, Watchdog::Patience patience)
      : process_(sandbox(), command, to_.read_end.get(), from_.write_end.get(), -1),
        watchdog_(process_, patience) {}

  // False: the patience is used up.
  bool hears() {
    char letter;
    return watchdog_.wait_for(from_.read_end.get(), POLLIN) && read(from_.read_end.get(), &letter, 1) == 1;
  }
  // Asks, and waits for the answer.
  bool answers() {
    if (write(to_.write_end.get(), "a", 1) != 1) return false;
    watchdog_.asked();
    return hears();
  }
  Watchdog& watchdog() { return watchdog_; }

 private:
  static Sandbox sandbox() {
    Sandbox sandbox;
    sandbox.mounts = toolchain_mounts();
    sandbox.isolation = Isolation::none;
    return sandbox;
  }

  Pipe to_ = make_pipe(), from_ = make_pipe();
  SandboxedProcess process_;
  Watchdog watchdog_;
};

const std::vector<std::string> kEchoes = {"/usr/bin/bash", "-c", "exec cat <&3 >&4"},
                               kChatters = {HAIR_IDLER, "chatters"};

// The time until we get a processor to read its answer is not idling either.
TEST(Watchdog, LeavesAloneWhatAnswersQuicklyOnABusyMachine) {
  const BusyMachine busy;
  Talking echo(kEchoes, {.idle_seconds = 5, .cpu_seconds = 10, .wall_seconds = 600});
  for (int i = 0; i < 100; ++i) {
    // The scheduler makes a process wait for new work after it has computed a lot.
    for (const double start = timing::cpu_seconds(); timing::cpu_seconds() < start + 0.004;) {
    }
    ASSERT_TRUE(echo.answers());
  }
  echo.watchdog().look();
  EXPECT_LT(echo.watchdog().idle_seconds(), 0.2);
}

// Two processes that wake each other up idle 15 us and more an answer by the kernel's clocks: a right P2
// answers 50,000 times.
TEST(Watchdog, TakesNoWakingUpForIdling) {
  constexpr int kAnswers = 20000;
  Talking echo(kEchoes, {.idle_seconds = 5, .cpu_seconds = 10, .wall_seconds = 600});
  for (int i = 0; i < kAnswers; ++i) ASSERT_TRUE(echo.answers());
  echo.watchdog().look();
  EXPECT_LT(echo.watchdog().idle_seconds(), 5e-6 * kAnswers);
}

// The process writes unasked messages, with a nap of 50 us before each.
TEST(Watchdog, ForgivesNoWakingUpForMessagesThatAnswerNothing) {
  Talking chatters(kChatters, {.idle_seconds = 0.2, .cpu_seconds = 10, .wall_seconds = 200});
  while (chatters.hears()) continue;
  EXPECT_STREQ(chatters.watchdog().why(), "asleep");
  EXPECT_EQ(chatters.watchdog().wakeup_seconds(), 0);
}

TEST(Watchdog, ForgivesWakingUpWithinABound) {
  Talking chatters(kChatters,
                   {.idle_seconds = 0.2, .cpu_seconds = 10, .wakeup_seconds = 0.1, .wall_seconds = 200});
  while (chatters.watchdog().asked(), chatters.hears()) continue;
  EXPECT_STREQ(chatters.watchdog().why(), "asleep");
  EXPECT_LE(chatters.watchdog().wakeup_seconds(), 0.1);
}

// Thirty threads that wake up together queue behind each other: the sum of these waits is many times the time
// that passes.
TEST(Watchdog, CountsWaitsOfThirtyThreadsOnce) {
  SandboxedProcess::Activity before{.alive = true, .started = true}, after = before;
  for (int thread = 1; thread <= 30; ++thread) {
    before.busy[thread] = {.computed = 1, .queued = 2};
    after.busy[thread] = {.computed = 1.001, .queued = 2 + 0.01 * thread};
  }
  after.busy[31] = {.computed = 0.002, .queued = 0.1};  // this wait began in between
  const SandboxedProcess::Activity::Busy busy = busy_between(before, after);
  EXPECT_NEAR(busy.computed, 0.032, 1e-12) << "on several processors at once";
  EXPECT_NEAR(busy.queued, 0.3, 1e-12);
}

TEST(Watchdog, CountsWhatIdlesBeforeItsEnd) {
  Talking leaving({"/usr/bin/sleep", "0.7"}, {.idle_seconds = 5, .cpu_seconds = 10, .wall_seconds = 200});
  leaving.watchdog().wait_for_end(1);
  EXPECT_GT(leaving.watchdog().idle_seconds(), 0.5);
}

// Any worker has waited enough at some time, whatever the kernel counts.
TEST(Watchdog, EndsWhatTakesTooLong) {
  Waiting computing(kComputes, {.idle_seconds = 5, .cpu_seconds = 50, .wall_seconds = 0.5});
  EXPECT_STREQ(computing.wait().why(), "out of time");
}

}  // namespace
}  // namespace grader::sandbox

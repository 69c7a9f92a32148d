// Shell programs replace a scene's process: a child that crashes, ends, or hangs.
#include "hair/live/child.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <cerrno>

namespace hair {
namespace {

std::vector<std::string> shell(const std::string& script) {
  return {"/bin/sh", "-c", script};
}

// Its messages, until it has ended.
struct Life {
  std::vector<std::string> messages;
  std::string end;
};

Life whole_life(Child& child) {
  Life life;
  for (;;) {
    if (auto message = child.next(20)) life.messages.push_back(*message);
    if (const auto end = child.ended()) {
      life.end = *end;
      return life;
    }
  }
}

class ChildTest : public testing::Test {
 protected:
  void SetUp() override { signal(SIGPIPE, SIG_IGN); }  // as catch_interruption does
};

TEST_F(ChildTest, GetsItsSettingsAndCommandsAndSaysItsMessages) {
  Child child(shell("read a; read b; printf '{\"a\":\"%s %s\"}\\n' \"$a\" \"$b\""), "1 2");
  child.tell("pause");
  const Life life = whole_life(child);
  EXPECT_EQ(life.messages, std::vector<std::string>{R"({"a":"1 2 pause"})"});
  EXPECT_EQ(life.end, "The code ended the program before the first step was over, with exit code 0.");
}

TEST_F(ChildTest, NamesACrashWithTheExerciseAndTheStepsBefore) {
  const std::pair<const char*, std::string> rows[] = {
      {"echo '. 16'; echo '{\"kind\":\"frame\",\"time\":1,\"steps\":17}'; kill -SEGV $$",
       "The code crashed after step 17: a segmentation fault: the code read or wrote memory that is not its "
       "own."},
      {"echo '. 16'; echo; echo '@ H6 _ZN4hair7correctEv'; kill -SEGV $$",
       "The code crashed in H6 (hair::correct) after step 16: "},
      {"kill -ABRT $$", "The code crashed before the first step was over: it was aborted"}};
  for (const auto& [script, said] : rows) {
    Child child(shell(script), "1 1");
    const std::string end = whole_life(child).end;
    EXPECT_TRUE(said.ends_with('.') ? end == said : end.starts_with(said)) << script << ": " << end;
  }
}

TEST_F(ChildTest, AsksAnEndlessLoopWhereItIs) {
  Child child(shell("trap \"echo '@ P1 '\" USR1; echo ready; while :; do :; done"), "1 1");
  while (!child.next(20)) continue;
  const std::optional<std::string> stopped = child.stop_if_silent(std::chrono::seconds(0));
  ASSERT_TRUE(stopped);
  EXPECT_TRUE(stopped->starts_with("The code did not come back in P1 before")) << *stopped;
}

TEST_F(ChildTest, SaysNothingMoreAboutTroubleThatItHasTold) {
  Child child(shell("echo '{\"kind\":\"trouble\",\"text\":\"H1\"}'; exit 3"), "1 1");
  const Life life = whole_life(child);
  EXPECT_EQ(life.messages.size(), 1U);
  EXPECT_EQ(life.end, "");
}

TEST_F(ChildTest, EndsAnEndlessLoopAndNamesIt) {
  Child child(shell("echo '. 5'; while :; do :; done"), "1 1");  // no earlier step took time
  std::optional<std::string> stopped;
  while (!stopped) {
    EXPECT_FALSE(child.next(20));
    stopped = child.stop_if_silent(std::chrono::seconds(1));
  }
  EXPECT_EQ(*stopped, "The code did not come back after step 5, for 1 s, and was ended: an endless loop?");
  EXPECT_EQ(whole_life(child).end, "") << "it is said once";
}

TEST_F(ChildTest, LetsStepsTakeTenTimesTheSlowestSoFar) {
  Child child(shell("echo '. 1'; sleep 0.5; echo '. 2'; sleep 2.5; echo '{\"kind\":\"frame\",\"steps\":3}'; "
                    "read a; read b"),
              "1 1");
  std::optional<std::string> frame;
  while (!frame) {
    frame = child.next(20);
    ASSERT_FALSE(child.stop_if_silent(std::chrono::seconds(1)));
  }
}

TEST_F(ChildTest, EndsWithItsOwner) {
  pid_t process = 0;
  {
    Child child(shell("echo $$; while :; do :; done"), "1 1");
    std::optional<std::string> line;
    while (!line) line = child.next(20);
    process = static_cast<pid_t>(std::stol(*line));
    EXPECT_EQ(kill(process, 0), 0);
  }
  EXPECT_EQ(kill(process, 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

TEST_F(ChildTest, IsToldNothingAfterItsEnd) {
  Child child(shell("exit 0"), "1 1");
  whole_life(child);
  child.tell("go");
  EXPECT_FALSE(child.next(0));
  EXPECT_FALSE(child.stop_if_silent(std::chrono::seconds(0)));
}

}  // namespace
}  // namespace hair

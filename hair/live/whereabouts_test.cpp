// A process names the exercise and the function in which it crashes, or in which a signal asks it.
#include "hair/live/whereabouts.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <string>

namespace hair {

void crashes();
void does_not_come_back(int descriptor);

namespace {

struct Told {
  std::string text;
  int status = 0;
};

// Runs a process that reports its whereabouts and then calls `does`. `asks`: the test asks it, and ends it.
Told told_by(const std::function<void(int descriptor)>& does, bool asks) {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  const pid_t process = fork();
  if (process == 0) {
    say_whereabouts(ends[1]);
    does(ends[1]);
    _exit(0);
  }
  close(ends[1]);
  Told told;
  std::array<char, 256> piece{};
  for (ssize_t size = 0; (size = read(ends[0], piece.data(), piece.size())) > 0;) {
    told.text.append(piece.data(), static_cast<std::size_t>(size));
    if (asks && told.text == "ready") kill(process, SIGUSR1);
    if (asks && told.text.find("\n@ ") != std::string::npos && told.text.back() == '\n')
      kill(process, SIGKILL);
  }
  close(ends[0]);
  waitpid(process, &told.status, 0);
  return told;
}

TEST(Whereabouts, OfACrashAreToldBeforeItEndsAsItWould) {
  const Told told = told_by([](int) { crashes(); }, false);
  EXPECT_EQ(told.text, "\n@ H6 _ZN4hair7crashesEv\n");
  EXPECT_TRUE(WIFSIGNALED(told.status) && WTERMSIG(told.status) == SIGSEGV) << told.status;
}

TEST(Whereabouts, OfALoopAreToldWhenItIsAsked) {
  const Told told = told_by(does_not_come_back, true);
  EXPECT_EQ(told.text, "ready\n@ H6 _ZN4hair18does_not_come_backEi\n");
  EXPECT_TRUE(WIFSIGNALED(told.status) && WTERMSIG(told.status) == SIGKILL) << told.status;
}

TEST(Whereabouts, AreNotToldOfCodeThatIsNoExercise) {
  const Told told = told_by([](int) { raise(SIGABRT); }, false);
  EXPECT_EQ(told.text, "");
  EXPECT_TRUE(WIFSIGNALED(told.status) && WTERMSIG(told.status) == SIGABRT) << told.status;
}

}  // namespace
}  // namespace hair

// STAFF ONLY. Tests progress on a terminal and in a pipe, by a clock of the test's own.
#include "grader/class_folder/progress.h"

#include <gtest/gtest.h>

#include <sstream>

namespace grader::inline class_folder {
namespace {

TEST(Progress, ATerminalHasALineForEachStep) {
  double now = 100;
  std::ostringstream out;
  Progress progress(4, out, true, [&] { return now; });
  progress.step("alice: kept", false);
  now += 90;
  progress.step("bob: 12");
  now += 90;
  progress.step("carol: 13");
  progress.step("dave: 14");
  EXPECT_EQ(out.str(),
            "[1/4] alice: kept\n"
            "[2/4, about 3 min left] bob: 12\n"
            "[3/4, about 2 min left] carol: 13\n"
            "[4/4] dave: 14\n");
}

// 180 hand-ins take 20 s each: there is a line a minute, and each estimate is right.
TEST(Progress, APipeHasALineAMinute) {
  double now = 0;
  std::ostringstream out;
  Progress progress(180, out, false, [&] { return now; });
  int lines = 0;
  for (int i = 1; i <= 180; ++i) {
    now += 20;
    out.str("");
    progress.step("somebody");
    if (out.str().empty()) continue;
    ++lines;
    const int minutes = (180 - i) / 3;
    EXPECT_EQ(out.str(), std::to_string(i) + " of 180 done, about " +
                             (minutes > 0 ? std::to_string(minutes) + " min" : "less than a minute") +
                             " left\n");
  }
  EXPECT_EQ(lines, 59);
}

}  // namespace
}  // namespace grader::class_folder

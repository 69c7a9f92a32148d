// STAFF ONLY. How many cases of a category hold, where a worker answers: the reference's S1.
#include <gtest/gtest.h>

#include "grader/suite/trial.h"

namespace grader {
namespace {

// A system of one unknown, whose matrix is 1.
void ask(Trial& trial) {
  const std::vector<double> one = {1};
  MessageWriter request;
  request.put(1).put(1e-20).put(4).put(1).put(std::span<const double>(one)).put(std::span<const double>(one));
  trial.ask(request, [](int, const std::vector<double>& x, std::vector<double>& y) {
    y = x;
    return true;
  });
}

std::optional<CaseCount> counted(const std::function<void(Trial&)>& run) {
  WorkerSetup setup;
  setup.kit = HAIR_KIT_DIR;
  setup.exercise = "S1";
  setup.objects = {setup.kit / "lib/S1.so"};
  setup.log = "/dev/null";
  setup.isolated = false;
  setup.allowance->limit = share_of(Budget(), 10);
  Student student(setup);
  return count_of({"Name", "Title", 1, run}, student, Random("seed", "count"));
}

TEST(CountedCases, FailOnceEachAndTheOthersHold) {
  const std::optional<CaseCount> count = counted([](Trial& trial) {
    for (int i = 0; i < 5; ++i) {
      ask(trial);
      trial.expect(i != 1, "the second");
      trial.expect(i != 1, "the second, once more");
      trial.expect_at_most(i == 3 ? 2 : 0, 1, "the fourth");
    }
  });
  ASSERT_TRUE(count);
  EXPECT_EQ(count->cases, 5);
  EXPECT_EQ(count->held, 3);
}

TEST(CountedCases, AreNotThoseThatAreAskedAside) {
  const std::optional<CaseCount> count = counted([](Trial& trial) {
    ask(trial);
    trial.expect(false, "the first");
    trial.ask_aside([&] {
      ask(trial);
      ask(trial);
      trial.expect(false, "what excuses nothing");
    });
    trial.expect(false, "the first, once more");
    ask(trial);
    trial.expect(true, "the second");
  });
  ASSERT_TRUE(count);
  EXPECT_EQ(count->cases, 2);
  EXPECT_EQ(count->held, 1);
}

}  // namespace
}  // namespace grader

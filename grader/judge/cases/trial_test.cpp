// STAFF ONLY. Tests comparisons of numbers, and the sentences about failures.
#include "grader/judge/cases/trial.h"

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <limits>
#include <vector>

namespace grader::inline judge {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Returns how the case fails in a trial; its status is `passed` if it holds.
CaseFailed failure_of(const std::function<void(Trial&)>& ask) {
  Student nobody{WorkerSetup{}};
  Trial trial(nobody, Random("seed", "a case"));
  try {
    ask(trial);
  } catch (const CaseFailed& failure) {
    return failure;
  }
  return {Status::passed, "", ""};
}

CaseFailed verdict(double error, double bound) {
  return failure_of([&](Trial& trial) {
    trial.describe("a hidden case");
    trial.expect_at_most(error, bound, "the error of x", "more for staff");
  });
}

TEST(Bound, HoldsUpToItselfAndNotForNan) {
  EXPECT_EQ(verdict(1, 1).status, Status::passed);
  EXPECT_EQ(verdict(0, 0).status, Status::passed);
  EXPECT_EQ(verdict(1.0000001, 1).status, Status::wrong);
  EXPECT_EQ(verdict(kNan, 1).status, Status::wrong);
  EXPECT_EQ(verdict(1, kNan).status, Status::wrong);
  EXPECT_EQ(verdict(std::numeric_limits<double>::infinity(), 1).status, Status::wrong);
}

TEST(Bound, KeepsTheLargestRatioOfAllButQuestionsAside) {
  Student nobody{WorkerSetup{}};
  Trial trial(nobody, Random("seed", "nearest"), WhenWrong::count);
  for (const double error : {0.25, 0.5, 0.0}) trial.expect_at_most(error, 2, "the error of x");
  trial.expect_close({Eigen::Vector2d(3, 4), Eigen::Vector2d(0, 0), 1}, 2, "the error of v");
  trial.expect_at_most(3, {2, 4}, "the error beyond a tolerance of 2");
  trial.expect_at_most(0, 0, "the error of nothing");
  trial.ask_aside([&] { trial.expect_at_most(1, 2, "the error of x"); });
  const std::map<std::string, double> expected = {{"the error of x", 0.25},
                                                  {"the error of v", 2.5},
                                                  {"the error beyond a tolerance of 2", 0.25},
                                                  {"the error of nothing", 0}};
  EXPECT_EQ(trial.nearest(), expected);
}

TEST(Feedback, TellsStaffHowFarFromTheLimit) {
  const CaseFailed failure = verdict(0.0625, 0.03125);
  EXPECT_EQ(failure.feedback, "the error of x is 2 times the limit");
  EXPECT_EQ(failure.detail, "a hidden case: the error of x: 0.0625, bound 0.03125; more for staff");
  EXPECT_EQ(verdict(0.0033, 0.0005).feedback, "the error of x is 6.6 times the limit");
  EXPECT_EQ(verdict(2e-300, 1e-306).feedback, "the error of x is 2e+06 times the limit");
  EXPECT_EQ(verdict(1e-300, 0).feedback, "the error of x is above its limit, 0");
  EXPECT_EQ(verdict(kNan, 1).feedback, "the error of x is not a finite number");
}

// Returns the student's hint about numbers where (1, 2, 3) is expected.
std::string hint_of(const std::vector<double>& numbers, const std::vector<double>& expected = {1, 2, 3}) {
  const CaseFailed failure = failure_of([&](Trial& trial) {
    trial.expect_near(
        {Eigen::VectorXd::Map(numbers.data(), std::ssize(numbers)),
         Eigen::VectorXd::Map(expected.data(), std::ssize(expected)), 1, Eigen::Vector3d(4, 5, 6)},
        1e-9, "the error of x");
  });
  return failure.hint.empty() && failure.status == Status::wrong ? "nothing" : failure.hint;
}

TEST(Hint, IsOneOfAFewSentences) {
  EXPECT_EQ(hint_of({1, 2, 3 + 1e-10}), "");
  EXPECT_EQ(hint_of({-1, -2, -3}), "Its numbers are -1 times what is expected: a sign?");
  EXPECT_EQ(hint_of({0.5, 1, 1.5, 2}, {1, 2, 3, 4}), "Its numbers are 1/2 times what is expected: a factor?");
  EXPECT_EQ(hint_of({1.1, 2.2, 3.3, 4.4}, {1, 2, 3, 4}), "nothing")
      << "a factor that code may choose could carry hidden inputs out";
  EXPECT_EQ(
      hint_of({0, 0, 0}),
      "All of it is 0: never written, left out by a condition or a loop's bounds, or terms that cancel?");
  EXPECT_EQ(hint_of({1, 2, 0}), "It is right but for its last entries: a loop's bound?");
  EXPECT_EQ(hint_of({7, 2, 3}), "It is right but for its first entries: a loop's bound?");
  EXPECT_EQ(hint_of({1, -2, 3}), "It is right but for signs of some entries.");
  EXPECT_EQ(hint_of({1, kNan, 3}),
            "One of its numbers is no number: 0/0, a division by 0, or the root of a negative one?");
  EXPECT_EQ(
      hint_of({4, 5, 6}),
      "It is an input, or what stood there before the call, unchanged: never written, or nothing done?");
  EXPECT_EQ(hint_of({2, 1, 5}), "nothing");
  EXPECT_EQ(hint_of({}, {}), "");
}

TEST(Hint, SaysWhatStoppedACall) {
  const auto told = [&](Outcome outcome, const std::string& note) {
    return failure_of([&](Trial& trial) {
             trial.reply_of({outcome, MessageReader({}), note}, kTooManyProducts);
           })
        .hint;
  };
  EXPECT_EQ(told(Outcome::stopped, ""), "It takes more products with the matrix than the step limit allows.");
  EXPECT_EQ(
      told(Outcome::broke_rules, kNestedCalls),
      "Its calls of given functions lie within each other too deeply: does a matrix or a force call what "
      "uses it?");
  EXPECT_EQ(told(Outcome::broke_rules, "anything else"), "");
}

std::optional<CaseCount> counted_without_worker(const std::function<void(Trial&)>& run) {
  Student nobody{WorkerSetup{}};
  return count_of({"Name", "Title", 1, run}, nobody, Random("seed", "count"));
}

TEST(Count, IsNothingWhereTheCategoryEndsEarly) {
  bool last = false;
  EXPECT_FALSE(counted_without_worker([&](Trial& trial) {
    trial.expect(false, "the first");
    trial.require(false, "nothing is there");
    last = true;
  }));
  EXPECT_FALSE(counted_without_worker([](Trial& trial) {
    trial.expect(false, "the first");
    throw MalformedMessage("too short");
  }));
  EXPECT_FALSE(last);
}

TEST(Random, IsTheSameOnEveryMachine) {
  // The standard fixes std::seed_seq and std::mt19937_64 to the bit.
  Random random("seed", "purpose");
  EXPECT_EQ(random.uniform(), 0x1.7b321b0acccecp-1);
  EXPECT_EQ(random.integer(0, 1'000'000), 303'773);
}

TEST(Random, DependsOnSeedAndPurpose) {
  const double first = Random("seed", "purpose").uniform();
  EXPECT_EQ(Random("seed", "purpose").uniform(), first);
  EXPECT_NE(Random("seed", "another").uniform(), first);
  EXPECT_NE(Random("another", "purpose").uniform(), first);
}

}  // namespace
}  // namespace grader::judge

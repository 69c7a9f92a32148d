// STAFF ONLY. Tests hints of the public checks: a mistake that numbers show is named, and other numbers get
// no hint.
#include "handout/check/hint.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace {

using Numbers = std::vector<double>;
using checks::hint;

constexpr double kBound = 1e-9;

class Hints : public testing::Test {
 protected:
  Numbers numbers(std::size_t count) {
    Numbers all(count);
    for (double& value : all) value = normal_(random_);
    return all;
  }
  std::string told(const Numbers& actual, const Numbers& expected, int block = 1) {
    return hint(actual, expected, kBound, block);
  }
  // Right results are off by rounding.
  Numbers times(double factor, Numbers all) {
    for (double& value : all) value *= factor * (1 + 1e-14 * normal_(random_));
    return all;
  }

  std::mt19937 random_{7};
  std::normal_distribution<double> normal_;
};

TEST_F(Hints, NameAFactorOfAllNumbers) {
  for (const std::size_t count : {2u, 3u, 12u, 100u}) {
    const Numbers expected = numbers(count);
    EXPECT_EQ(told(times(-1, expected), expected), "-1 times what was expected: a sign?");
    if (count < 4) continue;
    EXPECT_EQ(told(times(2, expected), expected), "2 times what was expected: a factor?");
    EXPECT_EQ(told(times(-0.5, expected), expected), "-0.5 times what was expected: a factor?");
    EXPECT_EQ(told(times(1e-3, expected), expected), "0.001 times what was expected: a factor?");
  }
  EXPECT_EQ(told({4}, {2}), "") << "of one number there is always a factor";
  EXPECT_EQ(told({-4}, {4}), "-1 times what was expected: a sign?");
  EXPECT_EQ(told({4, 0, 0}, {2, 0, 0}), "") << "and where all others are 0";
  EXPECT_EQ(told({2, 4, 6, -2, -4, -6}, {1, 2, 3, -1, -2, -3}), "") << "a force at both ends is one vector";
}

TEST_F(Hints, NameAnEndThatIsWrong) {
  const Numbers expected = numbers(15);
  Numbers actual = expected;
  actual[14] += 1;
  EXPECT_EQ(told(actual, expected), "right but for the last entry: a loop's bound?");
  EXPECT_EQ(told(actual, expected, 3), "right but for the last 3 entries: a loop's bound?");
  actual[11] = 7;
  EXPECT_EQ(told(actual, expected, 3), "right but for the last 6 entries: a loop's bound?")
      << "fewer than half";
  actual[8] = 0;
  EXPECT_EQ(told(actual, expected, 3), "") << "more than half are no end";
  actual = expected;
  actual[0] = 0;
  EXPECT_EQ(told(actual, expected, 3), "right but for the first 3 entries: a loop's bound?");
  actual[1] = actual[2] = 0;
  EXPECT_EQ(told(actual, expected, 3),
            "right but for the first 3 entries, where 0 stands: never written, or a loop's bound?");
  actual = expected;
  actual[5] = 0;
  EXPECT_EQ(told(actual, expected, 3), "") << "one in the middle";
}

TEST_F(Hints, NameWhatIsNoNumber) {
  const Numbers expected = numbers(4);
  Numbers actual = expected;
  actual[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(told(actual, expected).find("entry 2 is no number"), 0u);
  actual[2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(told(actual, expected),
            "entry 2 is infinite: a division by 0, or a variable that was never set?");
  const std::uint64_t fresh = 0xfefefefefefefefe;
  std::memcpy(&actual[1], &fresh, sizeof fresh);
  EXPECT_EQ(told(actual, expected), "entry 1 was never set");
  EXPECT_EQ(
      told(Numbers(4), expected),
      "all of it is 0: never written, left out by a condition or a loop's bounds, cut off by a min or max, "
      "a factor that is 0, a term that is missing, or terms that cancel?");
}

TEST_F(Hints, NameWhatIsMadeOfAVariableThatWasNeverSet) {
  const std::string made = ": was it made from a variable that was never set, or read beyond an end?";
  EXPECT_EQ(told({1, -5.3e303, 2}, {1, 3, 2}), "entry 1 is huge" + made);
  EXPECT_EQ(told({1, 1e291}, {1, 1e291}), "") << "expected to be that large";
  EXPECT_EQ(told({1, 4.7e-310}, {1, 2}), "entry 1 is tiny" + made);
  EXPECT_EQ(told({2, 4.7e-310}, {1, 0}), "") << "as good as 0";
  EXPECT_EQ(checks::hint_of_one(-1e304, 2, false), "it is huge" + made);
}

TEST_F(Hints, OfOneNumberKnowSmallFactors) {
  using checks::hint_of_one;
  EXPECT_EQ(hint_of_one(-2, 2, false), "-1 times what was expected: a sign?");
  EXPECT_EQ(hint_of_one(1, 2, true), "0.5 times what was expected: a factor?");
  EXPECT_EQ(hint_of_one(1, 2, false), "") << "by chance";
  EXPECT_TRUE(hint_of_one(0, 2, false).starts_with("it is 0: never written"));
  EXPECT_EQ(hint_of_one(std::numeric_limits<double>::infinity(), 2, false),
            "it is infinite: a division by 0, or a variable that was never set?");
  EXPECT_EQ(hint_of_one(1.37, 2, true), "");
  EXPECT_EQ(hint_of_one(1, 0, true), "");
}

TEST_F(Hints, NameSignsOfSomeEntries) {
  Numbers expected = numbers(5), actual = expected;
  actual[1] = -actual[1];
  actual[3] = -actual[3];
  EXPECT_EQ(told(actual, expected), "right but for signs of some entries");
}

TEST_F(Hints, NameATranspose) {
  Numbers expected = numbers(18), actual = expected;
  std::swap(actual[10], actual[12]);
  std::swap(actual[11], actual[15]);
  std::swap(actual[14], actual[16]);
  EXPECT_EQ(told(actual, expected, 9), "the transpose of what was expected") << "of the second matrix";
  EXPECT_EQ(told(expected, expected, 9), "");
  std::swap(actual[3], actual[4]);
  EXPECT_EQ(told(actual, expected, 9), "") << "and the first one is neither";
}

TEST_F(Hints, NameWhatStoodThereBefore) {
  const Numbers expected = numbers(6), before = numbers(6);
  EXPECT_EQ(hint(before, expected, kBound, 3, before),
            "the input, or the values from before, unchanged: never written, nothing done, or undone again?");
  EXPECT_EQ(hint(expected, expected, kBound, 3, expected), "") << "where nothing is to be changed";
  EXPECT_EQ(hint(numbers(6), expected, kBound, 3, before), "");
}

TEST_F(Hints, NameNumbersThatAreStillThoseOfTheCheck) {
  const Numbers expected = numbers(6);
  Numbers actual = expected;
  actual[2] = actual[4] = checks::kFill;
  EXPECT_EQ(told(actual, expected), "wrong where 1000 stands, as before the call: never written?");
  EXPECT_EQ(told({checks::kFill}, {7}), "wrong where 1000 stands, as before the call: never written?");
  actual[1] += 1;
  EXPECT_EQ(told(actual, expected), "") << "and another one is wrong";
  actual = expected;
  actual[2] = checks::kFill;
  EXPECT_EQ(told(actual, expected), "") << "a number may be 1000";
}

// Noise gives no hint, nor do results with small errors in all entries, nor right results.
TEST_F(Hints, AreSilentWhereNothingIsClear) {
  for (int repeat = 0; repeat < 1000; ++repeat) {
    const Numbers expected = numbers(3 + repeat % 20);
    EXPECT_EQ(told(numbers(expected.size()), expected), "");
    EXPECT_EQ(hint(numbers(9), numbers(9), kBound, 9, numbers(9)), "");
    Numbers actual = expected;
    for (double& value : actual) value += 0.1 * normal_(random_);
    EXPECT_EQ(told(actual, expected), "");
    actual = expected;
    for (double& value : actual) value *= 1 + 1e-7 * normal_(random_);
    EXPECT_EQ(told(actual, expected), "") << "a solver that stops too early";
    EXPECT_EQ(told(expected, Numbers(expected.size())), "") << "where 0 is expected";
  }
  EXPECT_EQ(told({}, {}), "");
  EXPECT_EQ(told({1, 2}, {1}), "");
}

}  // namespace

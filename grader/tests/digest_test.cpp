// STAFF ONLY. Tests that the public checks show a student the first failure, a place to look, names, and the
// categories at stake.
#include "handout/check/digest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include "handout/check/apart.h"
#include "solver/test_refusal.h"

namespace {

using namespace checks;
using tests::says;

Finding finding(const std::string& suite, const std::string& name, Finding::State state,
                std::vector<std::string> failures = {}, const std::string& hint = "") {
  return {suite, name, "check.cpp", 7, state, std::move(failures), hint, ""};
}

const Finding kRight = finding("Energy", "OfOne", Finding::State::passed);
const Finding kWrong =
    finding("Balance", "IsKept", Finding::State::failed,
            {"the sum\nerror = 2\nGoogle Test trace:\nexercises/H2/check.cpp:9: two strands"}, "a sign?");

const std::vector<Category> kCategories = {
    {"Energy", "The energy", 2, {"energy"}, {{"half", "the half", {}}}},
    {"Balance",
     "The balance",
     3,
     {"force"},
     {{"ends", "both ends", {}}, {"sign", "the sign", {"HasItsSign"}}, {"none", "", {"IsLong"}}}},
    {"WholeRun", "The whole run", 1, {}, {}}};
const Asked kAsked = {"H2", "build/check", kCategories};

TEST(Digest, OfRightChecksIsALine) {
  EXPECT_EQ(digest(kAsked, {kRight}, false), "H2: all 1 check pass\n");
}

TEST(Digest, ShowsTheFirstFailureAndWhatIsAtStake) {
  const std::string before =
      "H2: 1 of 2 checks pass, 1 fail\n"
      "Balance.IsKept (exercises/H2/check.cpp:7):\n"
      "  for two strands\n"
      "  the sum\n"
      "  error = 2\n"
      "  Hint: a sign?\n"
      "  Where to look: both ends\n";
  EXPECT_EQ(digest(kAsked, {kRight, kWrong}, false),
            before +
                "At stake: The balance, 3 points. Passing: 2 points; in grading alone: 1 point\n"
                "All of it: build/check --full\n");
  EXPECT_EQ(digest(kAsked, {kRight, kWrong}, true),
            before +
                "\npoints  category\n"
                "     2  The energy                                    passes\n"
                "     3  The balance                                   fails\n"
                "     1  The whole run                                 in grading alone\n");
}

TEST(Digest, PointsToTheRowThatNamesTheCheck) {
  Finding one = kWrong;
  one.name = "HasItsSign/0";
  EXPECT_TRUE(says(digest(kAsked, {one}, false), "Where to look: the sign\n"));
  one.name = "IsLong";
  EXPECT_FALSE(says(digest(kAsked, {one}, false), "Where to look"));
}

TEST(Digest, NeedsFifteenLines) {
  std::string long_one;
  for (int i = 0; i < 40; ++i) long_one += std::string(300, 'x') + "\n";
  std::vector<Finding> findings = {kRight};
  for (int i = 0; i < 50; ++i)
    findings.push_back(
        finding("Balance", "Number" + std::to_string(i), Finding::State::failed, {long_one}, "a sign?"));
  for (const char* function : {"", "add_force", "energy"}) {
    findings.push_back(finding("Energy", "Waits", Finding::State::waits));
    findings.back().waits_for = function;
  }
  const std::string told = digest(kAsked, findings, false);
  EXPECT_LE(std::ranges::count(told, '\n'), 15) << told;
  EXPECT_TRUE(says(told, "First make add_force, energy pass: 2 checks wait for it\n"));
  EXPECT_TRUE(says(told, "waiting: 2 points"));
  EXPECT_GE(std::ranges::count(digest(kAsked, findings, true), '\n'), 50 * 40);
}

TEST(CategoryOf, IsFoundInASuiteWithParameters) {
  EXPECT_EQ(category_of(kCategories, "Balance"), &kCategories[1]);
  EXPECT_EQ(category_of(kCategories, "Each/Balance"), &kCategories[1]);
  EXPECT_EQ(category_of(kCategories, "Energy/Integrator"), &kCategories[0]);
  EXPECT_EQ(category_of(kCategories, "Other"), nullptr);
}

TEST(Digest, SaysWhatAPlaceOutsideMayComeFrom) {
  const Finding outside = finding("Balance", "OfOne", Finding::State::broke_off,
                                  {"Assertion `index >= 0 && index < size()' failed."});
  EXPECT_TRUE(says(digest(kAsked, {outside}, false), "Hint: a place outside of a vector or matrix"));
}

TEST(HowItEnded, NamesTheErrorAndTheLineOfYourFile) {
  EXPECT_EQ(
      how_it_ended(0,
                   "==3==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x1 at pc 0x2\n"
                   "    #0 0x3 in f /given/x.h:3\n    #1 0x3 in ConjGrad /a/student/conj_grad.cpp:17:5\n"),
      "AddressSanitizer: heap-buffer-overflow\nin student/conj_grad.cpp:17:5");
  EXPECT_EQ(how_it_ended(0, "/a/student/x.cpp:3:4: runtime error: division by zero\n"),
            "runtime error: division by zero\nin student/x.cpp:3:4:");
  EXPECT_EQ(how_it_ended(
                0,
                "==1==ERROR: AddressSanitizer: attempting double-free on 0x6 in thread T0:\n    #0 0x1 in f "
                "/home/student/given/x.cpp:1\n    #1 0x1 in g /home/student/a/student/y.cpp:2\n"),
            "AddressSanitizer: attempting double-free\nin student/y.cpp:2");
  EXPECT_EQ(how_it_ended(SIGABRT, "/usr/include/c++/12/bits/x.h:1: f(): Assertion 'n < size()' failed.\n"),
            "Assertion 'n < size()' failed.");
  EXPECT_TRUE(says(how_it_ended(SIGXCPU, ""), "never ends"));
}

}  // namespace

// STAFF ONLY. What the public checks tell a student: the first failure, a place to look, names, and the categories at stake.
#include "handout/check/digest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "handout/check/apart.h"

namespace {

using namespace checks;

Finding finding(const std::string& suite, const std::string& name, Finding::State state,
                std::vector<std::string> failures = {}) {
  return {suite, name, "a_check.cpp", 7, state, std::move(failures), ""};
}

const Finding kRight = finding("Energy", "OfOne", Finding::State::passed);
const Finding kWrong =
    finding("Force", "IsBalanced", Finding::State::failed, {"the sum\nerror = 2\nhint       = a sign?"});

const Asked kAsked = {"H2",
                      "",
                      "build/check",
                      {{"The energy", "Energy.*"}, {"The balance", "*Balanced"}, {"The force", "Force.*"}},
                      {{"the sum of all forces", "Force.IsB*"}}};
const TextTables kTables = {{{"The energy", "2"}, {"The balance", "3"}, {"The whole run", "1"}},
                            {{"the sum of all forces is not 0", "both ends"}}};

TEST(Digest, OfRightChecksIsALine) {
  EXPECT_EQ(digest(kAsked, kTables, {kRight}, false), "H2: all 1 check pass\n");
}

TEST(Digest, ShowsTheFirstFailureAndWhatIsAtStake) {
  const std::string told = digest(kAsked, kTables, {kRight, kWrong}, false);
  EXPECT_EQ(told,
            "H2: 1 of 2 checks pass, 1 fail\n\n"
            "Force.IsBalanced (checks/a_check.cpp:7):\n"
            "  the sum\n"
            "  error = 2\n"
            "  Hint: a sign?\n"
            "  Where to look: both ends\n"
            "All of it: build/check --full\n\n"
            "points  category\n"
            "     2  The energy                                    passes\n"
            "     3  The balance                                   fails\n"
            "     1  The whole run                                 in grading alone\n");
}

TEST(Digest, NeedsFifteenLinesBesideTheTable) {
  std::string long_one;
  for (int i = 0; i < 40; ++i) long_one += std::string(300, 'x') + "\n";
  std::vector<Finding> findings = {kRight};
  for (int i = 0; i < 50; ++i)
    findings.push_back(finding("Force", "Number" + std::to_string(i), Finding::State::failed, {long_one}));
  findings.push_back(finding("Product", "Waits", Finding::State::waits));
  findings.back().waits_for = "add_force";
  const std::string told = digest(kAsked, kTables, findings, false);
  const std::string before = told.substr(0, told.find("points  category"));
  EXPECT_LE(std::ranges::count(before, '\n'), 15);
  EXPECT_NE(told.find("First make add_force pass: 1 check waits for it\n"), std::string::npos);
  const std::string full = digest(kAsked, kTables, findings, true);
  EXPECT_GE(std::ranges::count(full, '\n'), 50 * 40);
}

TEST(Digest, ReadsAFactorFromTwoNumbers) {
  const Finding near =
      finding("Energy", "OfOne", Finding::State::failed,
              {"The difference between a and b is 2, which exceeds c, where\na evaluates to 4,\nb "
               "evaluates to 2, and\nc evaluates to 1e-9.\n"});
  EXPECT_NE(digest(kAsked, kTables, {near}, false).find("Hint: 2 times what was expected: a factor?\n"),
            std::string::npos);
}

TEST(Digest, ReadsAFactorFromEqualityOfNumbers) {
  const Finding equal =
      finding("Energy", "OfOne", Finding::State::failed,
              {"Expected equality of these values:\n  energy(x)\n    Which is: 1.5\n  0.75\nfor l0 = 2"});
  EXPECT_NE(digest(kAsked, kTables, {equal}, false).find("Hint: 2 times what was expected: a factor?\n"),
            std::string::npos);
  const Finding count =
      finding("Energy", "OfOne", Finding::State::failed,
              {"Expected equality of these values:\n  f\n    Which is: (1, 2)\n  g\n    Which is: (2, 4)"});
  EXPECT_EQ(digest(kAsked, kTables, {count}, false).find("Hint"), std::string::npos);
}

TEST(Digest, OfANumberThatIsNoEnergyReadsNoFactor) {
  const Finding near = finding("Rate", "OfOne", Finding::State::failed,
                               {"a evaluates to 4,\nb evaluates to 2, and\nc evaluates to 1e-9.\n"});
  EXPECT_EQ(digest(kAsked, kTables, {near}, false).find("Hint"), std::string::npos);
}

TEST(Digest, SaysWhatAPlaceOutsideMayComeFrom) {
  const Finding outside = finding("Force", "OfOne", Finding::State::broke_off,
                                  {"Assertion `index >= 0 && index < size()' failed."});
  EXPECT_NE(digest(kAsked, kTables, {outside}, false).find("Hint: a place outside of a vector or matrix"),
            std::string::npos);
}

TEST(Patterns, AreThoseOfGoogleTest) {
  EXPECT_TRUE(fits("A.b", "A.b"));
  EXPECT_TRUE(fits("A.b", "X:*.b"));
  EXPECT_TRUE(fits("A.bcd", "A.b*d"));
  EXPECT_FALSE(fits("A.bcd", "A.b"));
  EXPECT_FALSE(fits("A.b", "A.b?*"));
}

TEST(TextTables, AreReadInPlainLetters) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "digest_test_text.md";
  std::ofstream(path)
      << "# T\n\n| category | points | asks for |\n|---|---|---|\n| The energy | 2 | all |\n\n"
         "| what you see | where to look |\n|---|---|\n| $S$ is `0` | $k = 2 EI/\\bar l$ |\n";
  const TextTables tables = read_text_tables(path.string());
  ASSERT_EQ(tables.categories.size(), 1U);
  EXPECT_EQ(tables.categories[0].title, "The energy");
  EXPECT_EQ(tables.categories[0].points, "2");
  ASSERT_EQ(tables.symptoms.size(), 1U);
  EXPECT_EQ(tables.symptoms[0].seen, "S is 0");
  EXPECT_EQ(tables.symptoms[0].look, "k = 2 EI/mean l");
  EXPECT_EQ(plain("$\\lvert l - l_0 \\rvert$; $v \\mathrel{+}= \\Delta v$"), "|l - l_0|; v += Delta v");
  EXPECT_EQ(plain("$k\\varphi$ and $\\dot J v$"), "k phi and dJ/dt v");
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
  EXPECT_NE(how_it_ended(SIGXCPU, "").find("never ends"), std::string::npos);
}

}  // namespace

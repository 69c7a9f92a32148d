// STAFF ONLY. Tests that checks that crash, leave or never end affect no other check. This program also holds
// the broken checks: it runs each of them as a student's check, and compares their results.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "handout/check/apart.h"

TEST(Broken, Passes) {}
TEST(Broken, Fails) {
  RecordProperty("hint", "a hint");
  EXPECT_EQ(1, 2) << "on purpose";
}
TEST(Broken, Crashes) {
  std::raise(SIGSEGV);
}
TEST(Broken, PassesAfterThat) {}
TEST(Broken, Leaves) {
  std::exit(0);
}
TEST(Broken, Throws) {
  throw std::runtime_error("thrown on purpose");
}
TEST(Broken, NeverEnds) {
  volatile bool goes_on = true;
  while (goes_on) continue;
}
TEST(Broken, PassesAtTheEnd) {}

int main() {
  testing::InitGoogleTest();
  using State = checks::Finding::State;
  const std::pair<State, const char*> expected[] = {
      {State::passed, ""},
      {State::failed, "on purpose"},
      {State::broke_off, ""},  // by a signal, or by a sanitizer
      {State::passed, ""},
      {State::broke_off, "the program left in the middle of it"},
      {State::failed, "thrown on purpose"},
      {State::broke_off, "a loop that never ends?"},
      {State::passed, ""}};
  std::vector<checks::Finding> findings;
  const testing::TestSuite& suite = *testing::UnitTest::GetInstance()->GetTestSuite(0);
  for (int i = 0; i < suite.total_test_count(); ++i)
    findings.push_back({suite.name(), suite.GetTestInfo(i)->name(), "", 0, State::waits, {}, "", ""});
  std::vector<checks::Finding*> all;
  for (checks::Finding& one : findings) all.push_back(&one);
  checks::run_apart(all, 1);
  int wrong = findings[1].hint == "a hint" ? 0 : 1;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    std::string said;
    for (const std::string& failure : findings[i].failures) said += failure + "\n";
    if (findings[i].state == expected[i].first && said.find(expected[i].second) != std::string::npos)
      continue;
    ++wrong;
    std::printf("%s: state %d, \"%s\"\n", findings[i].name.c_str(), static_cast<int>(findings[i].state),
                said.c_str());
  }
  std::printf("[  PASSED  ] %zu tests.\n", findings.size() - static_cast<std::size_t>(wrong));
  return wrong == 0 && findings.size() == std::size(expected) ? 0 : 1;
}

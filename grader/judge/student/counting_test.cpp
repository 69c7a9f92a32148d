// STAFF ONLY. Tests how many cases of a category hold when a worker with the reference's S1 answers, and that
// each case of functions that compute nothing is counted.

#include <gtest/gtest.h>

#include "grader/course/course.h"
#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/suite_table.h"
#include "reference/S1/calls.h"

namespace grader::inline judge {
namespace {

using Eigen::VectorXd;

// Asks for the solution of a system of one unknown, whose matrix is 1.
void ask(CaseAsker& asker) {
  VectorXd x = VectorXd::Ones(1), b = x;
  int steps = 4;
  const Served one{1, 1, [](int, const std::vector<double>& in, std::vector<double>& out) {
                     out = in;
                     return true;
                   }};
  grader::ask<s1::Calls, s1::conj_grad>(asker, one, x, b, 1e-20, steps);
}
void ask(Trial& trial) {
  CaseAsker asker(trial);
  ask(asker);
}

std::optional<CaseCount> counted(const std::function<void(Trial&)>& run) {
  WorkerSetup setup;
  setup.kit = HAIR_KIT_DIR;
  setup.exercise = "S1";
  setup.objects = {setup.kit / "lib/S1.so"};
  setup.log = "/dev/null";
  setup.isolation = Isolation::none;
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

TEST(CountedCases, MayTakeSeveralCalls) {
  const std::optional<CaseCount> count = counted([](Trial& trial) {
    for (int i = 0; i < 3; ++i) {
      CaseAsker asker(trial);
      ask(asker);
      trial.expect(i != 1, "the second, after its first call");
      ask(asker);
      trial.expect(i != 1, "the second, after its last call");
    }
  });
  ASSERT_TRUE(count);
  EXPECT_EQ(count->cases, 3);
  EXPECT_EQ(count->held, 2);
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

class EmptyFunctions : public testing::TestWithParam<std::string> {
 protected:
  Student student() const {
    WorkerSetup setup;
    setup.kit = HAIR_KIT_DIR;
    setup.exercise = GetParam();
    setup.provided = read_course(HAIR_EXERCISES_JSON).find(GetParam())->prerequisites;
    setup.objects = {HAIR_EMPTY_FUNCTIONS};
    setup.log = "/dev/null";
    setup.isolation = Isolation::none;
    setup.cpu_seconds = 60;
    setup.allowance->limit = share_of(Budget(), 30);
    return Student(setup);
  }
};

std::vector<std::string> exercises() {
  std::vector<std::string> ids;
  for (const Exercise& exercise : read_course(HAIR_EXERCISES_JSON).exercises) ids.push_back(exercise.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(InTurn, EmptyFunctions, testing::ValuesIn(exercises()),
                         [](const auto& named) { return named.param; });

TEST_P(EmptyFunctions, GetAHint) {
  Student student = this->student();
  std::string hints;
  for (const Category& category : categories(GetParam())) {
    try {
      Trial trial(student, Random("a seed", category.name));
      category.run(trial);
    } catch (const CaseFailed& failure) {
      hints += failure.hint.empty() ? "" : category.name + ": " + failure.hint + "\n";
    }
  }
  student.finish();
  for (const char* said : {"All of it is 0", "is no number", "unchanged"})
    if (hints.find(said) != std::string::npos) return;
  ADD_FAILURE() << hints;
}

// A category whose cases are counted goes on after a wrong answer: it must not use a part that the answer
// lacks.
TEST_P(EmptyFunctions, DoNotEndTheCountOfCases) {
  Student student = this->student();
  int counted = 0;
  for (const Category& category : categories(GetParam()))
    if (const auto count = count_of(category, student, Random("a seed", category.name))) {
      ++counted;
      EXPECT_LT(count->held, count->cases) << category.name;
    }
  student.finish();
  EXPECT_GT(counted, 0);
}

}  // namespace
}  // namespace grader::judge

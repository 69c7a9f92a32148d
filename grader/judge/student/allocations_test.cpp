// STAFF ONLY. What functions allocate that promise to allocate nothing: all of it is counted, what the suite's own objects
// allocate is not, and the reference keeps the promise. And what students read of functions that compute nothing.
#include <gtest/gtest.h>

#include "all_calls.h"
#include "grader/course/course.h"
#include "grader/judge/suite_table.h"

namespace grader {
namespace {

const std::filesystem::path kKit = HAIR_KIT_DIR;

enum Which { kAll, kPromising };  // those with a function that promises to allocate nothing

std::vector<std::string> exercises(Which which) {
  std::vector<std::string> ids;
  for_each_exercise([&]<class Calls>() {
    bool promises = which == kAll;
    for_each_call<Calls>(
        [&]<int number>() { promises = promises || Calls::template At<number>::contract.allocates_nothing; });
    if (promises) ids.emplace_back(Calls::id);
  });
  return ids;
}

class Allocations : public testing::TestWithParam<std::string> {
 protected:
  Student student_of(const std::filesystem::path& object) const {
    WorkerSetup setup;
    setup.kit = kKit;
    setup.exercise = GetParam();
    setup.provided = read_course(HAIR_EXERCISES_JSON).find(GetParam())->prerequisites;
    setup.objects = {object};
    setup.log = "/dev/null";
    setup.isolation = Isolation::none;
    setup.cpu_seconds = 60;
    setup.allowance->limit = share_of(Budget(), 30);
    return Student(setup);
  }

  // How often a call of this object allocates, when all categories ask.
  int of(const std::filesystem::path& object) {
    Student student = student_of(object);
    for (const Category& category : categories(GetParam())) {
      try {
        Trial trial(student, Random("a seed", category.name));
        category.run(trial);
      } catch (const CaseFailed& failure) {
        ++failed_;
        hints_ += failure.hint.empty() ? "" : category.name + ": " + failure.hint + "\n";
      }
    }
    student.finish();
    return student.allocations();
  }

  int failed_ = 0;     // categories
  std::string hints_;  // that students read, a line each
};

const auto kId = [](const auto& named) { return named.param; };
INSTANTIATE_TEST_SUITE_P(InTurn, Allocations, testing::ValuesIn(exercises(kPromising)), kId);

TEST_P(Allocations, AreCountedWhereTheStudentsCodeMakesThem) {
  EXPECT_EQ(of(HAIR_ALLOCATING_EXERCISES), 1);
}

TEST_P(Allocations, OfTheReferenceAreNone) {
  EXPECT_EQ(of(kKit / "lib" / (GetParam() + ".so")), 0);
  EXPECT_EQ(failed_, 0);
}

class Hints : public Allocations {};

INSTANTIATE_TEST_SUITE_P(InTurn, Hints, testing::ValuesIn(exercises(kAll)), kId);

// Each exercise's report says of code that computes nothing that it does so, or that a number was never set.
TEST_P(Hints, ReachEachExercisesReport) {
  of(HAIR_ALLOCATING_EXERCISES);
  EXPECT_NE(hints_, "");
  for (const char* told : {"All of it is 0", "is no number", "unchanged"})
    if (hints_.find(told) != std::string::npos) return;
  ADD_FAILURE() << hints_;
}

// A category whose cases are counted goes on after a wrong answer: it must not look for what the answer lacks.
TEST_P(Allocations, NoWrongAnswersEndTheCountOfCases) {
  Student student = student_of(HAIR_ALLOCATING_EXERCISES);
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
}  // namespace grader

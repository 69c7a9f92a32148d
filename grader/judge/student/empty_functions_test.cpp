// STAFF ONLY. Tests functions that compute nothing: their reports say so, and each of their cases is counted.
#include <gtest/gtest.h>

#include "grader/course/course.h"
#include "grader/judge/cases/suite_table.h"

namespace grader::inline judge {
namespace {

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

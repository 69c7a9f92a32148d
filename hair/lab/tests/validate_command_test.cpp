// hairlab validate from outside: its validations, its messages, its exit codes.
#include <gtest/gtest.h>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

const ProgramSettings kStudent{.program = STUDENT_HAIRLAB};

TEST(ValidateCommand, ListsWhatThereIsInTheCourse) {
  const TestFolder folder;
  const std::string course = folder.write("course.json", R"({"exercises": {"H6": {"role": "absent"}}})");
  const std::string all = run_hairlab({"validate", "--list"}).output,
                    some = run_hairlab({"validate", "--list", "--course", course}).output;
  EXPECT_TRUE(has(all, "published-numbers: ") && has(all, "(no exercise)")) << all;
  EXPECT_TRUE(has(all, "chain-h6: ") && has(all, "(S1, H1, H4, H5, H6)")) << all;
  EXPECT_TRUE(has(some, "published-numbers: ") && !has(some, "H6")) << some;
}

TEST(ValidateCommand, RunsThoseThatAreAskedForInTheListsOrder) {
  const ProgramRun run = run_hairlab({"validate", "pendulum-rods", "published-numbers"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "") << "progress is for terminals";
  EXPECT_LT(run.output.find("published-numbers: "), run.output.find("pendulum-rods: ")) << run.output;
  EXPECT_FALSE(has(run.output, "chain-h6")) << run.output;
  EXPECT_TRUE(has(run.output, "20 of 20 checks hold\n")) << run.output;
}

TEST(ValidateCommand, SaysWhatIsNotWrittenYet) {
  // Validations that call no exercise can run, but nobody asks for them alone.
  const ProgramRun all = run_hairlab({"validate", "--quick"}, kStudent);
  EXPECT_EQ(all.code, 3);
  EXPECT_TRUE(has(all.output, "left out: it needs P1: student/explicit_integrators.cpp, ")) << all.output;

  const ProgramRun numbers = run_hairlab({"validate", "published-numbers"}, kStudent);
  EXPECT_EQ(numbers.code, 0) << numbers.errors;
}

}  // namespace
}  // namespace hair

// hairlab validate from outside: its validations, its messages, its exit codes.
#include <gtest/gtest.h>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

const ProgramSettings kStudent{.program = STUDENT_HAIRLAB};

TEST(ValidateCommand, ListsWhatThereIs) {
  const ProgramRun run = run_hairlab({"validate", "--list"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(has(run.output, "published-numbers: ")) << run.output;
  EXPECT_TRUE(has(run.output, "(no exercise)")) << run.output;
  EXPECT_TRUE(has(run.output, "chain-h6: ") && has(run.output, "(S1, H1, H4, H5, H6)")) << run.output;
}

TEST(ValidateCommand, LeavesOutWhatCallsExercisesThatTheCourseLeavesOut) {
  const TestFolder folder;
  const ProgramRun run =
      run_hairlab({"validate", "--list", "--course",
                   folder.write("course.json", R"({"exercises": {"H6": {"role": "absent"}}})")});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(has(run.output, "published-numbers: ") && !has(run.output, "H6")) << run.output;
}

TEST(ValidateCommand, AListThatIsLostIsNotASuccess) {
  expect_refused(run_hairlab({"validate", "--list"}, {.output = "/dev/full"}), 2,
                 "hairlab: the standard output can't be written (No space left on device)");
}

TEST(ValidateCommand, RunsThoseThatAreAskedForInTheListsOrder) {
  const ProgramRun run = run_hairlab({"validate", "pendulum-rods", "published-numbers"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "") << "progress is for terminals";
  EXPECT_LT(run.output.find("published-numbers: "), run.output.find("pendulum-rods: ")) << run.output;
  EXPECT_FALSE(has(run.output, "chain-h6")) << run.output;
  EXPECT_TRUE(has(run.output, "14 of 14 checks hold\n")) << run.output;
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

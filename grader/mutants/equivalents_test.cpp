// STAFF ONLY. Tests that each entry of an equivalents.json is a mutant of a solution, and has a reason.
#include "grader/mutants/equivalents.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grader/course/course.h"
#include "hair/io/files/read_file.h"

namespace grader::inline mutants {
namespace {

const std::filesystem::path kProject = HAIR_PROJECT;

// An entry that matches nothing is left from an older solution.
TEST(Equivalents, AreMutantsOfTheSolutions) {
  std::size_t count = 0;
  for (const Exercise& exercise : read_course(kProject / "handout/exercises.json").exercises) {
    const std::string source = hair::bytes_of(kProject / solution_of(exercise));
    const std::vector<Mutation> all = mutations_of(source);
    const std::vector<Equivalent> equivalents = equivalents_of(exercise.id, kProject);
    count += equivalents.size();
    for (const Equivalent& one : equivalents)
      EXPECT_TRUE(
          std::ranges::any_of(all, [&](const Mutation& mutation) { return one.is(source, mutation); }))
          << exercise.id << ": " << one.change << ", occurrence " << one.occurrence << ", in " << one.line;
  }
  EXPECT_GT(count, 20U);
}

}  // namespace
}  // namespace grader::mutants

// STAFF ONLY. The suite as a classifier: wrong programs, made of the reference by one small change each, lose points. The
// environment's HAIR_EXERCISE names the exercise, HAIR_MUTANTS how many wrong ones are tried (40), HAIR_MUTANTS_SEED which (1).
// Objects are kept: a test that was interrupted compiles nothing twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "grader/mutants/equivalents.h"
#include "grader/mutants/judging.h"
#include "grader/mutants/mutation.h"
#include "grader/tests/run_program.h"
#include "grader/tests/side_by_side.h"
#include "grader/tool/secret.h"
#include "grader/tool/settings_for_tests.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT;
constexpr std::size_t kLeastWrong = 40;

GradingSettings settings_for(const std::string& exercise) {
  GradingSettings settings = settings_for_tests();
  settings.exercise = exercise;
  settings.cache = fs::path(HAIR_GRADED) / "mutants";
  settings.secret = read_secret(HAIR_TEST_SECRET);
  fs::create_directories(settings.cache);
  return settings;
}

struct Mutant {
  std::string name;  // of the submission
  Mutation mutation;
  bool known = false;  // to be right
  Judgement judgement = Judgement::does_not_compile;
};

void judge_all(const Judging& judging, const std::string& source, std::vector<Mutant>& mutants) {
  side_by_side(mutants.size(), [&](std::size_t i) {
    mutants[i].judgement = judging.judge(mutants[i].name, mutated(source, mutants[i].mutation));
  });
}

TEST(Suite, TakesPointsOfEachWrongProgram) {
  const std::string id = environment("HAIR_EXERCISE", "");
  const GradingSettings settings = settings_for(id);
  const Exercise* exercise = settings.course.find(id);
  ASSERT_NE(exercise, nullptr) << "HAIR_EXERCISE must name an exercise; it is \"" << id << "\"";
  const std::string source = hair::bytes_of(kProject / "reference" / exercise->file);
  const std::vector<Mutation> order =
      drawn(mutations_of(source), std::stoull(environment("HAIR_MUTANTS_SEED", "1")));
  const auto count = static_cast<std::size_t>(std::stoi(environment("HAIR_MUTANTS", "40")));
  const std::vector<Equivalent> equivalents = equivalents_of(id, kProject);
  const Judging judging(settings);

  std::size_t tried = 0, wrong = 0, found = 0, equivalent = 0, broken = 0;
  // As many as are missing at once: others take the place of those that do not compile or are known.
  while (wrong < count && tried < order.size()) {
    std::vector<Mutant> mutants;
    for (; mutants.size() < count - wrong && tried < order.size(); ++tried) {
      Mutant mutant{"m" + std::to_string(tried), order[tried]};
      mutant.known = std::ranges::any_of(equivalents,
                                         [&](const Equivalent& one) { return one.is(source, order[tried]); });
      mutants.push_back(std::move(mutant));
    }
    judge_all(judging, source, mutants);
    for (const Mutant& mutant : mutants) {
      const bool loses = mutant.judgement == Judgement::loses_points;
      std::ostringstream what;
      what << exercise->file << ":" << line_number(source, mutant.mutation) << ": "
           << change_of(source, mutant.mutation) << ", occurrence " << occurrence_of(source, mutant.mutation)
           << ", in\n  " << line_of(source, mutant.mutation) << "\n";
      if (mutant.judgement == Judgement::does_not_compile) {
        ++broken;
      } else if (mutant.known) {
        ++equivalent;
        EXPECT_FALSE(loses) << what.str() << "is listed as equivalent, but it loses points";
      } else {
        ++wrong;
        found += loses;
        EXPECT_TRUE(loses)
            << what.str() << mutant.name
            << " gets all points. Write a case that finds it, or its reason into equivalents.json";
      }
    }
  }
  EXPECT_GE(wrong, std::min(kLeastWrong, count)) << "too few that compile";
  std::printf("%s: %zu of %zu wrong programs lose points (%.1f %%); %zu are equivalent, %zu do not compile\n",
              id.c_str(), found, wrong, wrong ? 100.0 * found / wrong : 100.0, equivalent, broken);
}

}  // namespace
}  // namespace grader

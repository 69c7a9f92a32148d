// STAFF ONLY. The suite as a classifier: wrong programs, made of the reference by one small change each, lose points. The
// environment's HAIR_EXERCISE names the exercise, HAIR_MUTANTS how many are made (60), HAIR_MUTANTS_SEED which (1). What was graded is
// kept: a test that was interrupted goes on where it was.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "grader/course/course.h"
#include "grader/mutants/mutation.h"
#include "grader/report/report.h"
#include "grader/tests/run_program.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

std::string from_environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value ? value : otherwise;
}

// A program that is right although it was changed.
struct Equivalent {
  std::string line, change, reason;
};

std::vector<Equivalent> equivalents_of(const std::string& exercise) {
  std::vector<Equivalent> all;
  std::ifstream in(fs::path(HAIR_PROJECT) / "grader/mutants/equivalents.json");
  const nlohmann::json lists = nlohmann::json::parse(in);
  for (const nlohmann::json& entry : lists.at(exercise))
    all.push_back({entry.at("line"), entry.at("change"), entry.at("why")});
  return all;
}

struct Mutant {
  std::string name;  // of the submission
  std::string line, change;
  int line_number;
};

class Suite : public testing::Test {
 protected:
  const std::string id_ = from_environment("HAIR_EXERCISE", "");
  const std::string seed_ = from_environment("HAIR_MUTANTS_SEED", "1");
  const fs::path folder_ = fs::path(HAIR_GRADED) / "mutants" / (id_ + "-" + seed_);

  std::vector<Mutant> make_mutants(const Exercise& exercise) const {
    const std::string source = read_file(fs::path(HAIR_PROJECT) / "reference" / exercise.file);
    const auto count = static_cast<std::size_t>(std::stoi(from_environment("HAIR_MUTANTS", "60")));
    std::vector<Mutant> mutants;
    for (const Mutation& mutation : some_of(mutations_of(source), count, std::stoull(seed_))) {
      const std::string number = std::to_string(mutants.size());
      mutants.push_back({"m" + std::string(3 - number.size(), '0') + number, line_of(source, mutation),
                         change_of(source, mutation), line_number(source, mutation)});
      fs::create_directories(folder_ / "submissions" / mutants.back().name);
      std::ofstream(folder_ / "submissions" / mutants.back().name / exercise.file)
          << mutated(source, mutation);
    }
    return mutants;
  }
};

TEST_F(Suite, TakesPointsOfEachWrongProgram) {
  const Course course = read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json");
  const Exercise* exercise = course.find(id_);
  ASSERT_NE(exercise, nullptr) << "HAIR_EXERCISE must name an exercise; it is \"" << id_ << "\"";
  fs::remove_all(folder_ / "submissions");
  const std::vector<Mutant> mutants = make_mutants(*exercise);
  const ProgramRun run = run_hairgrade(
      {"grade", (folder_ / "submissions").string(), "--exercise", id_, "--out", (folder_ / "grades").string(),
       "--cache", (folder_ / "cache").string(), "--secret", HAIR_TEST_SECRET, "--resume"});
  ASSERT_EQ(run.code, 0) << run.errors;

  const std::vector<Equivalent> equivalents = equivalents_of(id_);
  int wrong = 0, found = 0, equivalent = 0, broken = 0;
  for (const Mutant& mutant : mutants) {
    const std::optional<SubmissionResult> result = read_results(folder_ / "grades", mutant.name);
    ASSERT_TRUE(result && result->exercises.size() == 1) << mutant.name;
    const ExerciseResult& graded = result->exercises[0];
    const bool known = std::ranges::any_of(equivalents, [&](const Equivalent& one) {
      return one.line == mutant.line && one.change == mutant.change;
    });
    const bool loses = graded.points < graded.max_points;
    if (graded.status == Status::does_not_compile) {
      ++broken;
    } else if (known) {
      ++equivalent;
      EXPECT_FALSE(loses) << "listed as equivalent, but it loses points: line " << mutant.line_number << ", "
                          << mutant.change << ": " << mutant.line;
    } else {
      ++wrong;
      found += loses;
      EXPECT_TRUE(loses)
          << exercise->file << ":" << mutant.line_number << ": " << mutant.change << " in\n  " << mutant.line
          << "\ngets all points. Write a case that finds it, or its reason into equivalents.json";
    }
  }
  EXPECT_GE(wrong, 40 * static_cast<int>(mutants.size()) / 60) << "too few that compile";
  std::printf("%s: %d of %d wrong programs lose points (%.1f %%); %d are equivalent, %d do not compile\n",
              id_.c_str(), found, wrong, wrong ? 100.0 * found / wrong : 100.0, equivalent, broken);
}

}  // namespace
}  // namespace grader

// STAFF ONLY. Draws wrong programs, lets the judge grade them, and counts.
#include "grader/tests/mutants_found.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "grader/mutants/equivalents.h"
#include "grader/mutants/mutation.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

constexpr std::size_t kLeastWrong = 40;

struct Mutant {
  std::string name;  // is the submission's
  Mutation mutation;
  bool known = false;  // known to be right
  bool undefined = false;
  Judged judged = {};
};

std::string in_words(const Exercise& exercise, const std::string& source, const Mutation& mutation) {
  std::ostringstream words;
  words << exercise.file << ":" << line_number(source, mutation) << ": " << change_of(source, mutation)
        << ", occurrence " << occurrence_of(source, mutation) << ", in\n  " << line_of(source, mutation)
        << "\n";
  return words.str();
}

// Returns true if half of its ordinary cases fail, in the lost category that weighs most.
bool is_of_no_use(const std::vector<CaseResult>& lost) {
  const CaseResult& ordinary = *std::ranges::max_element(lost, {}, &CaseResult::max_points);
  return 2 * ordinary.held <= ordinary.cases;
}

}  // namespace

void expect_mutants_found(const Exercise& exercise, const Judge& judge, const std::string& advice) {
  const std::filesystem::path project = HAIR_PROJECT;
  const std::string source = hair::bytes_of(project / solution_of(exercise));
  const std::vector<Mutation> order =
      drawn(mutations_of(source), std::stoull(environment("HAIR_MUTANTS_SEED", "1")));
  const auto count = static_cast<std::size_t>(std::stoi(environment("HAIR_MUTANTS", "40")));
  const std::vector<Equivalent> equivalents = equivalents_of(exercise.id, project);

  struct Programs {
    int all = 0, of_no_use = 0;
  };
  std::map<std::size_t, Programs> losing;  // wrong programs by the number of lost categories
  std::size_t tried = 0, wrong = 0, found = 0, equivalent = 0, broken = 0;
  // Takes all missing programs at once, to replace those that do not compile or are known.
  while (wrong < count && tried < order.size()) {
    std::vector<Mutant> mutants;
    for (; mutants.size() < count - wrong && tried < order.size(); ++tried) {
      Mutant mutant{"m" + std::to_string(tried), order[tried]};
      const auto known = std::ranges::find_if(
          equivalents, [&](const Equivalent& one) { return one.is(source, order[tried]); });
      mutant.known = known != equivalents.end();
      mutant.undefined = mutant.known && known->undefined;
      mutants.push_back(std::move(mutant));
    }
    side_by_side(mutants.size(), [&](std::size_t i) {
      if (const std::string folder = environment("HAIR_TOLD", ""); !folder.empty())
        std::ofstream(std::filesystem::path(folder) / (exercise.id + "-" + mutants[i].name + ".change"))
            << in_words(exercise, source, mutants[i].mutation);
      mutants[i].judged = judge(mutants[i].name, mutated(source, mutants[i].mutation));
    });
    for (const Mutant& mutant : mutants) {
      const bool is_found = mutant.judged.judgement == Judgement::loses_points;
      if (mutant.judged.judgement == Judgement::does_not_compile) {
        ++broken;
      } else if (mutant.known) {
        ++equivalent;
        EXPECT_FALSE(is_found && !mutant.undefined)
            << in_words(exercise, source, mutant.mutation) << "is listed as equivalent, but it loses points";
      } else {
        ++wrong;
        found += is_found;
        if (const auto& lost = mutant.judged.lost; !lost.empty()) {
          ++losing[lost.size()].all;
          losing[lost.size()].of_no_use += is_of_no_use(lost);
          std::cout << mutant.name << " loses " << lost.size() << ":";
          for (const CaseResult& one : lost)
            std::cout << " " << one.name << " (" << one.held << " of " << one.cases << " hold);";
          std::cout << " " << in_words(exercise, source, mutant.mutation);
        }
        EXPECT_TRUE(is_found) << in_words(exercise, source, mutant.mutation) << mutant.name
                              << " is not found. " << advice;
      }
    }
  }
  // A short solution has no more mutants: then most of them compile.
  EXPECT_TRUE(wrong >= std::min(kLeastWrong, count) || (tried == order.size() && wrong + equivalent > broken))
      << "too few that compile: " << wrong;
  std::printf("%s: of %zu wrong programs %zu are found (%.1f %%); %zu are equivalent, %zu do not compile\n",
              exercise.id.c_str(), wrong, found, wrong ? 100.0 * found / wrong : 100.0, equivalent, broken);
  for (const auto& [categories, programs] : losing)
    std::printf("  %d lose %zu %s, %d of them of no use\n", programs.all, categories,
                categories == 1 ? "category" : "categories", programs.of_no_use);
}

}  // namespace grader

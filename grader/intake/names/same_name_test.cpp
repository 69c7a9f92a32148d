// STAFF ONLY. Tests that a rule chooses one of several files with the same name, or that it stays open.
#include "grader/intake/names/same_name.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "grader/intake/names/exercise_names.h"

namespace grader::inline intake {
namespace {

// Returns the paths of the best conj_grad.cpp, "a | b".
std::string taken(const std::vector<std::string>& paths) {
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto likeness = exercise_file(paths[i].substr(paths[i].rfind('/') + 1), {"conj_grad.cpp"}).value();
    all.push_back({i, paths[i], likeness.degree == Likeness::Degree::renamed, likeness.number});
  }
  const std::size_t best = put_best_first(all);
  std::string said;
  for (std::size_t i = 0; i < best; ++i) said += (i > 0 ? " | " : "") + std::string(all[i].path);
  return said;
}

TEST(SameName, ARuleDecidesWhateverTheOrder) {
  // The first path of each case counts.
  const std::vector<std::vector<std::string>> cases = {
      {"hair/student/conj_grad.cpp", "hair/Backup/conj_grad.cpp"},
      {"hair/student/conj_grad.cpp", "hair/student/old/conj_grad.cpp", "hair/x/conj_grad.cpp"},
      {"hair/STUDENT/conj_grad.cpp", "conj_grad.cpp", "hair/student/conj_grad (1).cpp"},
      {"conj_grad.cpp", "build/conj_grad.cpp", "cmake-build-debug/conj_grad.cpp", "out/conj_grad.cpp",
       "bin/student/conj_grad.cpp", "build2/conj_grad.cpp"},
      {"hw/conj_grad.cpp", "hw.bak/conj_grad.cpp", "old hw/conj_grad.cpp", "Copy of hw/conj_grad.cpp",
       "hw - Copy/conj_grad.cpp", "hw_copy/conj_grad.cpp", "backups/3/conj_grad.cpp", "hw-OLD/conj_grad.cpp"},
      {"backup/new/conj_grad.cpp", "backup/new/Conj_Grad.cpp"},
      {"Version 10/conj_grad.cpp", "Version 2/conj_grad.cpp", "version 9/conj_grad.cpp"},
      {"hw_v3/src/conj_grad.cpp", "hw_v1/src/conj_grad.cpp", "hw_v2/src/conj_grad.cpp"},
      {"hw (2)/conj_grad.cpp", "hw (1)/conj_grad.cpp"},
      {"conj_grad.cpp", "conj_grad-1.cpp", "conj_grad (7).cpp", "CONJ_GRAD.CPP"},
      {"conj_grad-12.cpp", "conj_grad-1.cpp", "conj_grad-2.cpp"},
      {"Version 2/student/conj_grad.cpp", "Version 1/student/conj_grad.cpp", "Version 3/conj_grad.cpp"},
  };
  for (std::vector<std::string> paths : cases) {
    const std::string first = paths.front();
    for (std::size_t i = 0; i < paths.size(); ++i) {
      EXPECT_EQ(taken(paths), first) << testing::PrintToString(paths);
      std::rotate(paths.begin(), paths.begin() + 1, paths.end());
    }
  }
}

TEST(SameName, NothingElseDecides) {
  const std::vector<std::vector<std::string>> cases = {
      {"a/conj_grad.cpp", "b/conj_grad.cpp"},
      {"conj_grad.cpp", "Version 2/conj_grad.cpp"},
      {"conj_grad.cpp", "src/conj_grad.cpp"},
      {"hair/conj_grad.cpp", "hair (1)/conj_grad.cpp"},  // unpacked once more: the second has the stubs
      {"lab-1/conj_grad.cpp", "lab-2/conj_grad.cpp"},
      {"exercise1/conj_grad.cpp", "exercise2/conj_grad.cpp"},
      {"hw v1/conj_grad.cpp", "project v2/conj_grad.cpp"},
      {"a/student/conj_grad.cpp", "b/student/conj_grad.cpp"},
      {"student/conj_grad.cpp", "Student/conj_grad.cpp"},
      {"CONJ_GRAD.cpp", "Conj_grad.cpp"},
      {"Conj_grad.cpp", "conj_grad (1).cpp"},
      {"builder/conj_grad.cpp", "goldfish/conj_grad.cpp"},
      {"old/conj_grad.cpp", "build/conj_grad.cpp"},
  };
  for (const std::vector<std::string>& paths : cases) EXPECT_EQ(taken(paths), paths[0] + " | " + paths[1]);
}

}  // namespace
}  // namespace grader::intake

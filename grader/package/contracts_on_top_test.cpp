// STAFF ONLY. Tests which given headers lie on top of the handout.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "grader/package/handout.h"
#include "grader/package/manifest.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;

// Lists the project's headers that a text includes, "hair/strand.h".
std::vector<std::string> included_by(const std::string& text) {
  static const std::regex line("#include \"([^\"]+)\"");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

// On top lie only the exercises' headers and those that these and the stubs include.
TEST(ContractsOnTop, AreThereAndNoOtherGivenCode) {
  const fs::path root = HAIR_SOURCE_DIR;
  const Course course = read_course(root / "handout/exercises.json");
  const Files files = handout_files({root, HAIR_GOLDEN_DIR}, course);
  std::vector<std::string> open = {"solver/lecture/linearSolver.h"};
  for (const Exercise& exercise : course.exercises) {
    open.push_back(exercise.header);
    for (const std::string& header : included_by(files.at(stub_of(exercise)))) open.push_back(header);
  }
  Paths contracts;
  while (!open.empty()) {
    const std::string header = open.back();
    open.pop_back();
    if (!contracts.insert(header).second) continue;
    ASSERT_TRUE(files.contains(header)) << header << " is a contract or a part of one, and must lie on top";
    for (const std::string& other : included_by(files.at(header))) open.push_back(other);
  }
  for (const auto& [path, text] : files)
    for (const char* room : {"solver/", "particles/", "hair/"})
      EXPECT_TRUE(!path.starts_with(room) || contracts.contains(path)) << path << " must lie below given/";
}

}  // namespace
}  // namespace grader::package

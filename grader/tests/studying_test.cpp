// STAFF ONLY. Tests hairgrade --study from outside, without hair: it grades a class of three twice.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "grader/tests/broken_links.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

constexpr const char* kNoHair = R"({"exercises": {
  "H1": {"role": "absent"}, "H2": {"role": "absent"}, "H3": {"role": "absent"},
  "H4": {"role": "absent"}, "H5": {"role": "absent"}, "H6": {"role": "absent"}}})";

// Grades everything once, for all tests.
class Studying : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    static const hair::TemporaryFolder shared("hairgrade-study");
    folder_ = shared.path();
    std::ofstream(folder_ / "secret") << "a secret for this test";
    std::ofstream(folder_ / "course.json") << kNoHair;
    without_ = grade("without", {});
    with_ = grade("with", {"--study"});
  }

  static ProgramRun grade(const string& where, const std::vector<string>& more) {
    std::vector<string> arguments = {"grade"};
    for (const char* name : {"perfect", "p1-midpoint-full-step", "segfault"})
      arguments.push_back(sample(name));
    for (const char* word : {"--secret", "secret", "--cache", "cache", "--course", "course.json"})
      arguments.push_back(word[0] == '-' ? string(word) : (folder_ / word).string());
    arguments.insert(arguments.end(), {"--no-images", "--out", (folder_ / where).string()});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_hairgrade(arguments);
  }

  inline static fs::path folder_;
  inline static ProgramRun without_, with_;
};

TEST_F(Studying, ChangesNoPointsAndIsLinked) {
  ASSERT_EQ(without_.code, 0) << without_.errors;
  ASSERT_EQ(with_.code, 0) << with_.errors;
  const auto bytes_of = [](const string& name) { return hair::bytes_of(folder_ / name); };
  EXPECT_EQ(bytes_of("with/grades.csv"), bytes_of("without/grades.csv"));
  for (const string who : {"perfect", "p1-midpoint-full-step", "segfault"}) {
    EXPECT_EQ(bytes_of("with/" + who + "/results.json"), bytes_of("without/" + who + "/results.json"));
    for (const string& page : {who + "/report.html", "staff/" + who + ".html", string("index.html")}) {
      EXPECT_TRUE(says(bytes_of("with/" + page), "study.html")) << page;
      EXPECT_FALSE(says(bytes_of("without/" + page), "study.html")) << page;
    }
  }
  EXPECT_EQ(broken_links(folder_ / "with"), std::vector<string>());
}

TEST_F(Studying, IsMadeUpForByResume) {
  const ProgramRun again = grade("with", {"--resume", "--study"});
  EXPECT_TRUE(says(again.output, "0 graded, 3 kept"));
  fs::copy(folder_ / "without", folder_ / "later", fs::copy_options::recursive);
  const ProgramRun later = grade("later", {"--resume", "--study", "--only", "perfect"});
  EXPECT_TRUE(says(later.output, "1 graded"));
  EXPECT_TRUE(fs::exists(folder_ / "later" / "perfect" / "study.html"));
  // One exercise is graded again: the study was of other code.
  fs::copy(folder_ / "later", folder_ / "one", fs::copy_options::recursive);
  ASSERT_EQ(grade("one", {"--only", "perfect", "--exercise", "S1"}).code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "one" / "perfect" / "study.html"));
  EXPECT_FALSE(says(hair::bytes_of(folder_ / "one" / "perfect" / "report.html"), "study.html"));
  // After grading without a study, nothing leads to an old one.
  ASSERT_EQ(grade("later", {"--only", "perfect"}).code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "later" / "perfect" / "study.html"));
  EXPECT_FALSE(fs::exists(folder_ / "later" / "perfect" / "study.json"));
}

}  // namespace
}  // namespace grader

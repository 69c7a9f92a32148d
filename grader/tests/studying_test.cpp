// STAFF ONLY. Tests hairgrade --study from outside, without hair: it grades a class of three twice.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "grader/record/record.h"
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

string without(string text, const string& part) {
  for (std::size_t at = text.find(part); at != string::npos; at = text.find(part, at))
    text.erase(at, part.size());
  return text;
}

TEST_F(Studying, ChangesNothingButThatThereIsALink) {
  ASSERT_EQ(without_.code, 0) << without_.errors;
  ASSERT_EQ(with_.code, 0) << with_.errors;
  EXPECT_EQ(without(with_.output, "/with/"), without(without_.output, "/without/"));
  int files = 0, links = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "without")) {
    if (!entry.is_regular_file() || entry.path().filename() == "timing.json" ||
        entry.path().filename() == "costs.html" || entry.path().filename() == kRecordFile)
      continue;
    ++files;
    const fs::path name = fs::relative(entry.path(), folder_ / "without");
    const string before = hair::bytes_of(entry.path()), after = hair::bytes_of(folder_ / "with" / name);
    const bool student =
        name.filename() == "results.json" || name.extension() == ".csv" || name.extension() == ".xml";
    EXPECT_TRUE(!student || after == before) << name;
    // A page has a line that links to the study; the staff's JSON says that there is one.
    string stripped = after;
    const string owner = name.stem().string();
    for (const string& place : {string(), "../" + owner + "/"})
      stripped = without(stripped,
                         "<p><a href=\"" + place +
                             "study.html\">Error against run time</a> of small scenes, beside ours.</p>\n");
    for (const char* who : {"perfect", "p1-midpoint-full-step", "segfault"})
      stripped = without(stripped, " <a href=\"" + string(who) + "/study.html\">study</a>");
    stripped = without(stripped, ",\n \"studied\": true");
    EXPECT_EQ(stripped, before) << name;
    links += after != before;
  }
  // Each has two pages and two files of JSON; the class has index.html, grades.csv, .lock.
  EXPECT_EQ(files, 3 * 4 + 4);
  EXPECT_EQ(links, 3 * 3 + 1);  // both pages and the staff's JSON of each, and the class's
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

TEST_F(Studying, OfAReferenceThatFailsStopsNoGrading) {
  const fs::path motions = folder_ / "cache" / "motions", aside = folder_ / "motions-aside";
  fs::rename(motions, aside);
  std::ofstream(motions) << "no folder";  // prevents storing reference solutions
  const ProgramRun run = grade("failed", {"--study", "--only", "perfect"});
  fs::remove(motions);
  fs::rename(aside, motions);
  EXPECT_EQ(run.code, 1) << run.errors;
  EXPECT_TRUE(says(run.output, "1 graded"));
  EXPECT_TRUE(says(run.errors, "the studies: the reference's failed: "));
  EXPECT_TRUE(fs::exists(folder_ / "failed" / "perfect" / "report.html"));
  EXPECT_FALSE(fs::exists(folder_ / "failed" / "perfect" / "study.html"));
}

}  // namespace
}  // namespace grader

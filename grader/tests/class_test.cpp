// STAFF ONLY. Tests the sample class, graded once by another test: all points are right, no student's page
// has texts of the staff, and nothing outside of the sandbox has changed. The environment's HAIR_CLASS names
// the class: "first", the default, "showcase" or "class".
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "grader/intake/names/names.h"
#include "grader/record/record.h"
#include "grader/report/facts/picture_files.h"
#include "grader/report/report.h"
#include "grader/result/result.h"
#include "grader/samples/sample.h"
#include "grader/tests/broken_links.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using tests::says;

std::string class_name() {
  return environment("HAIR_CLASS", "first");
}

fs::path graded() {
  return fs::path(HAIR_GRADED) / class_name();
}

std::vector<Sample> samples() {
  std::vector<Sample> all = read_samples(HAIR_PROJECT);
  const std::string name = class_name();
  std::erase_if(all, [&](const Sample& sample) {
    return !(name == "first" ? sample.first : name == "showcase" ? sample.showcase : sample.in_class());
  });
  return all;
}

SubmissionResult result_of(const std::string& name) {
  return recorded_result(graded(), name).value();
}

TEST(SampleClass, HasAReportForEverySampleAndNobodyElse) {
  std::set<std::string> expected, reports;
  for (const Sample& sample : samples()) expected.insert(submission_name(sample.name));
  for (const auto& entry : fs::directory_iterator(graded()))
    if (fs::exists(entry.path() / "report.html")) reports.insert(entry.path().filename().string());
  EXPECT_EQ(reports, expected);
}

// A student gets one folder, and nothing else of the class.
TEST(SampleClass, HasPagesThatLeadToWhatIsThere) {
  EXPECT_EQ(broken_links(graded()), std::vector<std::string>());
  for (const Sample& sample : samples())
    EXPECT_EQ(broken_links(graded() / submission_name(sample.name)), std::vector<std::string>());
}

TEST(SampleClass, EverybodyGetsTheirStatusesCategoriesAndPoints) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name + ": " + sample.shows);
    const SubmissionResult result = result_of(submission_name(sample.name));
    ASSERT_EQ(result.exercises.size(), sample.expected.size());
    for (const ExerciseResult& exercise : result.exercises) {
      const ExpectedResult& expected = sample.expected.at(exercise.id);
      std::string failures;
      std::set<std::string> failed;
      for (const CaseResult& one : exercise.cases)
        if (one.status != Status::passed && failed.insert(one.name).second)
          failures += "\n  " + one.name + ": " + one.feedback + " | " + one.detail;
      EXPECT_EQ(to_string(exercise.status), expected.status) << exercise.id << failures << "\n"
                                                             << exercise.staff_log;
      if (!expected.failed.empty()) {
        EXPECT_EQ(failed, std::set<std::string>(expected.failed.begin(), expected.failed.end()))
            << exercise.id << failures;
      }
      const double otherwise = expected.status == "passed" ? exercise.max_points : 0;
      EXPECT_NEAR(exercise.points, expected.points.value_or(otherwise), 1e-9) << exercise.id << failures;
    }
  }
}

// Asked of the first twelve samples alone (CMakeLists.txt).
TEST(SampleClass, IsTheReadmesTable) {
  Record record(graded());
  std::vector<SubmissionResult> results;
  for (const std::string& name : record.names()) {
    results.push_back(record.find_decided(name).value().result);
    results.back().isolation = Isolation::namespaces;  // in a container one line more says so
  }
  std::ostringstream table;
  print_table(table, results);
  EXPECT_TRUE(says(hair::bytes_of(fs::path(HAIR_PROJECT) / "README.md"), "\n```\n" + table.str() + "```\n"))
      << "README.md has another table than\n"
      << table.str();
}

TEST(SampleClass, ChangesNothingOutsideOfTheSandbox) {
  EXPECT_EQ(traces({graded(), HAIR_SAMPLE_CLASS}), std::vector<fs::path>());
}

TEST(SampleClass, PagesForStudentsHoldNothingOfTheStaffs) {
  for (const Sample& sample : samples()) {
    const std::string name = submission_name(sample.name);
    const SubmissionResult result = result_of(name);
    for (const char* file : {"results.json", "report.html"}) {
      SCOPED_TRACE(name + "/" + file);
      const std::string page = hair::bytes_of(graded() / name / file);
      ASSERT_FALSE(page.empty());
      for (const ExerciseResult& exercise : result.exercises)
        for (const CaseResult& one : exercise.cases)
          if (one.detail.size() > 12) {
            EXPECT_FALSE(says(page, one.detail));
          }
      for (const std::string& secret :
           {std::string(HAIR_BUILD), std::string(HAIR_PROJECT), std::string("hairgrade-"),
            std::string("/kit/"), std::string("serve_")})
        EXPECT_FALSE(says(page, secret));
      EXPECT_FALSE(says(page, "<script>alert"));
    }
  }
}

// Asked of the first twelve samples alone (CMakeLists.txt).
TEST(SampleClass, CanBePublishedBelowAnyAddress) {
  const fs::path site = graded().string() + "-site";
  fs::remove_all(site);
  const ProgramRun run = run_hairgrade({"site", graded().string(), "--out", site.string()});
  ASSERT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(broken_links(site), std::vector<std::string>());
  EXPECT_FALSE(fs::exists(site / "class/staff"));
  for (const auto& entry : fs::recursive_directory_iterator(site)) {
    if (entry.path().extension() != ".html") continue;
    for (const char* far : {"src=\"http", "src=\"/", "href=\"/", "url(http"})
      EXPECT_FALSE(says(hair::bytes_of(entry.path()), far)) << entry.path() << " asks for " << far;
  }
}

// The second time its objects came from the cache.
TEST(SampleClass, GradedAgainGivesTheSameBytes) {
  const fs::path again = graded().string() + "-again";
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(again)) {
    const fs::path name = fs::relative(entry.path(), again);
    if (!entry.is_regular_file() || !name.has_parent_path()) continue;  // the class's have none
    EXPECT_TRUE(hair::bytes_of(entry.path()) == hair::bytes_of(graded() / name)) << name;
    ++files;
  }
  EXPECT_GE(files, 4);  // two for the student, two for staff
}

// Counts all pictures except those that others show, too, such as the reference's.
TEST(SampleClass, NobodyTakesMoreThanAMegabyte) {
  std::map<std::string, std::size_t> shown_by, bytes;
  std::map<std::string, std::set<std::string>> pictures;
  for (const Sample& sample : samples()) {
    const std::string name = submission_name(sample.name);
    const SubmissionResult result = result_of(name);
    const auto add = [&](const std::vector<PictureResult>& some) {
      for (const PictureResult& picture : some)
        for (const std::string& png : {picture.student, picture.reference, picture.heat})
          if (!png.empty() && pictures[name].insert(picture_name(png)).second) ++shown_by[picture_name(png)];
    };
    for (const ExerciseResult& exercise : result.exercises) add(exercise.pictures);
    for (const char* file : {"/results.json", "/report.html"})
      bytes[name] += fs::file_size(graded() / (name + file));
    for (const char* ending : {".html", ".json"})
      bytes[name] += fs::file_size(graded() / "staff" / (name + ending));
  }
  for (auto& [name, size] : bytes) {
    for (const std::string& picture : pictures[name])
      if (shown_by[picture] == 1) size += fs::file_size(pictures_folder(graded()) / picture);
    EXPECT_LE(size, 1'000'000U) << name;
  }
  std::size_t files = 0;
  for (const auto& file : fs::directory_iterator(pictures_folder(graded()))) {
    EXPECT_EQ(shown_by.count(file.path().filename().string()), 1U) << file.path() << " is nobody's";
    ++files;
  }
  EXPECT_EQ(files, shown_by.size());
}

}  // namespace
}  // namespace grader

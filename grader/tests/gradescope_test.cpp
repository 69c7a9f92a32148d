// STAFF ONLY. Makes and unpacks the package for Gradescope; its run_autograder grades a sample with this
// build's hairgrade.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "grader/course/course.h"
#include "grader/report/gradescope_rules.h"
#include "grader/report/report.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using std::string;
using tests::says;

constexpr const char* kSecret = "a secret for this test";

int run(const std::vector<string>& words, const fs::path& folder = {}) {
  return hair::exit_code_of(hair::start_program({.words = words, .folder = folder})).value_or(-1);
}

void unpack(const fs::path& archive, const fs::path& folder) {
  fs::create_directories(folder);
  ASSERT_EQ(run({"/usr/bin/cmake", "-E", "tar", "xf", archive}, folder), 0);
}

class GradescopePackage : public testing::Test {
 protected:
  GradescopePackage() {
    std::ofstream(folder_.path() / "course.json") << course_of({"S1"});
    std::ofstream(folder_.path() / "secret") << kSecret;
  }

  void pack(std::vector<string> more = {}) {
    const string zip = folder_.path() / "autograder.zip";
    std::vector<string> words = {"package",  "gradescope",
                                 "--out",    zip,
                                 "--course", folder_.path() / "course.json",
                                 "--secret", folder_.path() / "secret"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun packed = run_hairgrade(words);
    ASSERT_EQ(packed.code, 0) << packed.errors;
    unpack(zip, place_ / "source");
  }

  // This sample loses some points. Where classes are allowed, its two folders look like one.
  void put_sample() const {
    unpack(fs::path(HAIR_SAMPLE_CLASS) / "starts-from-x.zip", place_ / "submission/some folder");
    fs::create_directories(place_ / "submission/other folder");
    std::ofstream(place_ / "submission/other folder/normal_equations.cpp") << "\n";
  }

  // Starts it as the platform does, but in other folders.
  int run_autograder() const {
    string script = hair::bytes_of(place_ / "source/run_autograder");
    const auto replace = [&](const string& what, const string& by) {
      const std::size_t at = script.find(what);
      ASSERT_NE(at, string::npos) << what;
      script.replace(at, what.size(), by);
    };
    replace("$source/hair/build/release/grader/tool/hairgrade", HAIRGRADE);
    replace("source=/autograder", "source=" + place_.string());
    return run({"/bin/sh", "-c", script, "run_autograder", place_});
  }

  Json results() const {
    const string text = hair::bytes_of(place_ / "results/results.json");
    EXPECT_EQ(broken_rules(text), std::vector<string>{});
    return Json::parse(text);
  }

  const hair::TemporaryFolder folder_{"gradescope-package"};
  const fs::path place_ = folder_.path() / "autograder";
};

TEST_F(GradescopePackage, HoldsSourcesAndTwoScriptsAndNothingThatWasBuilt) {
  pack();
  const fs::path source = place_ / "source";
  for (const char* script : {"setup.sh", "run_autograder"})
    EXPECT_TRUE((fs::status(source / script).permissions() & fs::perms::owner_exec) != fs::perms::none)
        << script;
  EXPECT_EQ(fs::status(source / "secret").permissions(), fs::perms(0600));
  EXPECT_EQ(fs::status(folder_.path() / "autograder.zip").permissions(), fs::perms(0600));
  EXPECT_TRUE(fs::exists(source / "hair/grader/setup.sh"));
  EXPECT_FALSE(fs::exists(source / "hair/build"));
  for (const char* script : {"setup.sh", "run_autograder"})
    for (const char* left : {"$PROGRAM", "$OPTIONS", "$PARTS", "$SECONDS"})
      EXPECT_FALSE(says(hair::bytes_of(source / script), left));
}

// Before the deadline the package holds nothing that a student must not see.
TEST_F(GradescopePackage, OfThePublicChecksHoldsNeitherSecretNorReference) {
  pack({"--checks-only"});
  const fs::path source = place_ / "source", project = HAIR_PROJECT;
  EXPECT_FALSE(fs::exists(source / "secret"));
  for (const Exercise& exercise : read_course(project / "handout/exercises.json").exercises) {
    // Only S1 must be written; students get the others solved.
    const fs::path from = exercise.id == "S1" ? unwritten_file_of(exercise) : solution_of(exercise);
    EXPECT_EQ(hair::bytes_of(source / "hair" / solution_of(exercise)), hair::bytes_of(project / from));
    for (const auto& file : fs::directory_iterator(source / "hair/reference" / exercise.id))
      EXPECT_TRUE(file.path().extension() == ".h" || file.path().filename() == exercise.file) << file.path();
  }
  for (const auto& file : fs::recursive_directory_iterator(source)) {
    for (const char* hidden : {"scene.json", ".samples", "full_head.cpp"})
      EXPECT_FALSE(says(file.path().string(), hidden)) << file.path();
    if (file.is_regular_file()) {
      EXPECT_FALSE(says(hair::bytes_of(file.path()), kSecret)) << file.path();
    }
  }
  EXPECT_TRUE(fs::exists(source / "hair/handout/check/golden/S1.txt"));
  EXPECT_TRUE(says(hair::bytes_of(source / "run_autograder"), "hairchecks\""));
}

// The platform's folder of a hand-in is one student's, whatever folders it has.
TEST_F(GradescopePackage, RunAutograderGivesTheStudentsPoints) {
  pack({});
  put_sample();
  std::ofstream(place_ / "submission_metadata.json")
      << R"({"created_at": "2026-03-04T10:15:00.0-08:00", "users": [{"id": 12}, {"id": 7}]})";
  EXPECT_EQ(run_autograder(), 0);
  EXPECT_EQ(results()["extra_data"]["student"], "7");
  EXPECT_FALSE(says(results()["output"].get<string>(), "Not graded")) << results()["output"];

  // This is the same file as the submission "7" of a class.
  fs::create_directories(folder_.path() / "7");
  fs::copy_file(place_ / "submission/some folder/conj_grad.cpp", folder_.path() / "7/conj_grad.cpp");
  const ProgramRun graded = run_hairgrade({"grade", folder_.path() / "7", "--out", folder_.path() / "grades",
                                           "--course", folder_.path() / "course.json", "--secret",
                                           folder_.path() / "secret", "--cache", place_ / "source/cache"});
  ASSERT_EQ(graded.code, 0) << graded.errors;
  const Json other = Json::parse(hair::bytes_of(folder_.path() / "grades/7/results.json"));
  EXPECT_EQ(results()["score"], other["score"]);
  EXPECT_GT(other["score"], 0);
  ASSERT_EQ(results()["tests"].size(), other["tests"].size());
  for (std::size_t i = 0; i < other["tests"].size(); ++i)
    for (const char* key : {"number", "name", "score", "max_score", "status"})
      EXPECT_EQ(results()["tests"][i][key], other["tests"][i][key]) << i;

  std::ofstream(place_ / "submission_metadata.json") << R"({"created_at": "t", "users": []})";
  EXPECT_EQ(run_autograder(), 0);
  EXPECT_TRUE(says(results()["output"].get<string>(), "not your fault"));
  EXPECT_EQ(results()["score"], 0);
}

// The name of a hand-in goes through the shell.
TEST_F(GradescopePackage, OfOneOfSeveralHandInsAsksForItsExercisesAlone) {
  Json course = Json::parse(hair::bytes_of(folder_.path() / "course.json"));
  course["exercises"]["S2"] = {{"role", "assigned"}};
  course["hand_ins"] = {{"week 1's \"$x\"", {{"exercises", {"S1"}}}}, {"week 2", {{"exercises", {"S2"}}}}};
  std::ofstream(folder_.path() / "course.json") << course;
  const auto refused = [&](std::vector<string> more, const string& because) {
    more.insert(more.begin(), {"package", "gradescope", "--out", folder_.path() / "x.zip", "--course",
                               folder_.path() / "course.json", "--secret", folder_.path() / "secret"});
    const ProgramRun run = run_hairgrade(more);
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(says(run.errors, because));
    EXPECT_FALSE(fs::exists(folder_.path() / "x.zip"));
  };
  refused({}, "name one by --hand-in: \"week 1's");
  refused({"--hand-in", "week 3"}, "has no hand-in \"week 3\"");
  refused({"--hand-in", "week 3", "--checks-only"}, "has no hand-in \"week 3\"");

  pack({"--hand-in", "week 1's \"$x\""});
  put_sample();
  std::ofstream(place_ / "submission_metadata.json")
      << R"({"created_at": "2026-03-04T10:15:00.0-08:00", "users": [{"id": 7}]})";
  EXPECT_EQ(run_autograder(), 0);
  double most = 0;
  const Json all = results();
  for (const Json& test : all["tests"]) {
    // Runs of scenes show all exercises, and give no points.
    EXPECT_TRUE(test["number"].get<string>().starts_with("S1") || test["max_score"] == 0) << test["number"];
    most += test["max_score"].get<double>();
  }
  EXPECT_EQ(most, 32);
  EXPECT_GT(all["score"], 0);
}

}  // namespace
}  // namespace grader

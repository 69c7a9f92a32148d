// STAFF ONLY. Makes and unpacks the package for Gradescope; its run_autograder grades a sample with this
// build's hairgrade.
#include "grader/course/course.h"
#include "grader/report/gradescope_rules.h"
#include "grader/report/report.h"
#include "grader/tests/in_a_folder.h"
#include "hair/io/files/start_program.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using std::string;
using tests::says;

int run_in(const std::vector<string>& words, const fs::path& folder = {}) {
  return hair::exit_code_of(hair::start_program({.words = words, .folder = folder})).value_or(-1);
}

void unpack(const fs::path& archive, const fs::path& folder) {
  fs::create_directories(folder);
  ASSERT_EQ(run_in({"/usr/bin/cmake", "-E", "tar", "xf", archive}, folder), 0);
}

class GradescopePackage : public InAFolder {
 protected:
  GradescopePackage() : InAFolder(course_of({"S1"})) {}

  ProgramRun package(const string& zip, std::vector<string> more) const {
    more.insert(more.begin(), {"package", "gradescope", "--out", zip, "--course", path("course.json"),
                               "--secret", path("secret")});
    return run_hairgrade(more);
  }

  void pack(const std::vector<string>& more = {}) const {
    const ProgramRun packed = package(path("autograder.zip"), more);
    ASSERT_EQ(packed.code, 0) << packed.errors;
    unpack(path("autograder.zip"), place_ / "source");
  }

  // This sample loses some points. Where classes are allowed, its two folders look like one.
  void put_sample() const {
    unpack(fs::path(HAIR_SAMPLE_CLASS) / "starts-from-x.zip", place_ / "submission/some folder");
    write("autograder/submission/other folder/normal_equations.cpp", "\n");
  }

  // Starts it as the platform does, but in other folders.
  int run_autograder() const {
    string script = read("autograder/source/run_autograder");
    const auto replace = [&](const string& what, const string& by) {
      const std::size_t at = script.find(what);
      ASSERT_NE(at, string::npos) << what;
      script.replace(at, what.size(), by);
    };
    replace("$source/hair/build/release/grader/tool/hairgrade", HAIRGRADE);
    replace("source=/autograder", "source=" + place_.string());
    return run_in({"/bin/sh", "-c", script, "run_autograder", place_});
  }

  Json results() const {
    const string text = read("autograder/results/results.json");
    EXPECT_EQ(broken_rules(text), std::vector<string>{});
    return Json::parse(text);
  }

  const fs::path place_ = root_ / "autograder";
};

TEST_F(GradescopePackage, HoldsSourcesAndTwoScriptsAndNothingThatWasBuilt) {
  pack();
  const fs::path source = place_ / "source";
  for (const char* script : {"setup.sh", "run_autograder"})
    EXPECT_TRUE((fs::status(source / script).permissions() & fs::perms::owner_exec) != fs::perms::none)
        << script;
  EXPECT_EQ(fs::status(source / "secret").permissions(), fs::perms(0600));
  EXPECT_EQ(fs::status(path("autograder.zip")).permissions(), fs::perms(0600));
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
      EXPECT_FALSE(says(hair::bytes_of(file.path()), read("secret"))) << file.path();
    }
  }
  EXPECT_TRUE(fs::exists(source / "hair/handout/check/golden/S1.txt"));
  EXPECT_TRUE(says(hair::bytes_of(source / "run_autograder"), "hairchecks\""));
}

// The platform's folder of a hand-in is one student's, whatever folders it has.
TEST_F(GradescopePackage, RunAutograderGivesTheStudentsPoints) {
  pack({});
  put_sample();
  write("autograder/submission_metadata.json",
        R"({"created_at": "2026-03-04T10:15:00.0-08:00", "users": [{"id": 12}, {"id": 7}]})");
  EXPECT_EQ(run_autograder(), 0);
  EXPECT_EQ(results()["extra_data"]["student"], "7");
  EXPECT_FALSE(says(results()["output"].get<string>(), "Not graded")) << results()["output"];

  // This is the same file as the submission "7" of a class.
  write("7/conj_grad.cpp", read("autograder/submission/some folder/conj_grad.cpp"));
  const ProgramRun graded = run({"grade", path("7"), "--course", path("course.json"), "--secret",
                                 path("secret"), "--cache", place_ / "source/cache"});
  ASSERT_EQ(graded.code, 0) << graded.errors;
  const Json other = Json::parse(read("grades/7/results.json"));
  EXPECT_EQ(results()["score"], other["score"]);
  EXPECT_GT(other["score"], 0);
  ASSERT_EQ(results()["tests"].size(), other["tests"].size());
  for (std::size_t i = 0; i < other["tests"].size(); ++i)
    for (const char* key : {"number", "name", "score", "max_score", "status"})
      EXPECT_EQ(results()["tests"][i][key], other["tests"][i][key]) << i;

  write("autograder/submission_metadata.json", R"({"created_at": "t", "users": []})");
  EXPECT_EQ(run_autograder(), 0);
  EXPECT_TRUE(says(results()["output"].get<string>(), "not your fault"));
  EXPECT_EQ(results()["score"], 0);
}

// The name of a hand-in goes through the shell.
TEST_F(GradescopePackage, OfOneOfSeveralHandInsAsksForItsExercisesAlone) {
  Json course = Json::parse(read("course.json"));
  course["exercises"]["S2"] = {{"role", "assigned"}};
  course["hand_ins"] = {{"week 1's \"$x\"", {{"exercises", {"S1"}}}}, {"week 2", {{"exercises", {"S2"}}}}};
  write("course.json", course.dump());
  const auto refused = [&](const std::vector<string>& more, const string& because) {
    expect_refused(package(path("x.zip"), more), because);
    EXPECT_FALSE(fs::exists(path("x.zip")));
  };
  refused({}, "name one by --hand-in: \"week 1's");
  refused({"--hand-in", "week 3"}, "has no hand-in \"week 3\"");
  refused({"--hand-in", "week 3", "--checks-only"}, "has no hand-in \"week 3\"");

  pack({"--hand-in", "week 1's \"$x\""});
  put_sample();
  write("autograder/submission_metadata.json",
        R"({"created_at": "2026-03-04T10:15:00.0-08:00", "users": [{"id": 7}]})");
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

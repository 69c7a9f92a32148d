// STAFF ONLY. The sample class's lists are read strictly, and packed the same way each time.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "grader/course/input.h"
#include "grader/samples/sample.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

// Of this test alone: others run at the same time.
fs::path scratch(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return fs::path(testing::TempDir()) / ("make_samples_test_" + std::string(test->name()) + "_" + name);
}

constexpr const char* kExercises = R"json({"exercises": [
    {"id": "A", "title": "a", "file": "a.cpp", "functions": ["a()"], "header": "a.h", "text": "a.md",
     "checks": "a_check.cpp", "prerequisites": [], "libraries": [], "points": 5, "role": "assigned"},
    {"id": "B", "title": "b", "file": "b.cpp", "functions": ["b()"], "header": "b.h", "text": "b.md",
     "checks": "b_check.cpp", "prerequisites": [], "libraries": [], "points": 5, "role": "assigned"}]})json";

// A project with two exercises and one sample, whose patch turns "one" to "two" in a file that reads `source`.
fs::path small_project(const std::string& source) {
  const fs::path project = scratch("project");
  const fs::path samples = project / "grader" / "samples";
  fs::remove_all(project);
  for (const char* folder : {"list", "patches", "solutions/plain"}) fs::create_directories(samples / folder);
  for (const char* folder : {"handout/student", "reference"}) fs::create_directories(project / folder);
  std::ofstream(project / "handout" / "exercises.json") << kExercises;
  std::ofstream(project / "handout" / "student" / "b.cpp") << "stub\n";
  std::ofstream(project / "reference" / "b.cpp") << "reference\n";
  std::ofstream(samples / "solutions" / "plain" / "a.cpp") << source;
  std::ofstream(samples / "patches" / "bug.patch") << "--- a/a.cpp\n+++ b/a.cpp\n@@ -1 +1 @@\n-one\n+two\n";
  std::ofstream(samples / "list" / "bugs.json")
      << R"({"samples": [{"name": "bug", "shows": "A bug.", "form": "folder", "files": {"a.cpp": "plain"},
             "patch": "bug.patch", "expect": {"A": {"status": "wrong", "points": 3}}}]})";
  return project;
}

// Adds a list with one sample, which has these further entries.
void add_sample(const fs::path& project, const std::string& name, const std::string& entries) {
  std::ofstream(project / "grader" / "samples" / "list" / "more.json")
      << R"({"samples": [{"name": ")" << name << R"(", "shows": "It.", )" << entries << "}]}";
}

void expect_refused(const fs::path& project, const std::string& words) {
  try {
    read_samples(project);
    FAIL() << "read, for all that: " << words;
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

struct Outcome {
  int code;
  std::string output;
};

Outcome make_samples(const fs::path& project, const fs::path& out,
                     const fs::path& showcase = scratch("project") / "showcase") {
  const fs::path log = scratch("log");
  const std::string command = std::string("'") + HAIR_MAKE_SAMPLES + "' '" + project.string() + "' '" +
                              out.string() + "' '" + showcase.string() + "' '" + out.string() +
                              "-attacks' >'" + log.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, hair::bytes_of(log)};
}

TEST(MakeSamples, GivesTheSameBytesWhateverTheTimeZoneAndLocale) {
  const fs::path project = small_project("one\n"), out = project / "class", again = project / "again";
  ASSERT_EQ(make_samples(HAIR_PROJECT, out).code, 0);
  setenv("TZ", "America/New_York", 1);
  setenv("LC_ALL", "C", 1);
  ASSERT_EQ(make_samples(HAIR_PROJECT, again).code, 0);
  unsetenv("TZ");
  unsetenv("LC_ALL");
  for (const Sample& sample : read_samples(HAIR_PROJECT)) {
    if (sample.form == SampleForm::folder) continue;
    EXPECT_TRUE(hair::bytes_of(out / sample.file_name()) == hair::bytes_of(again / sample.file_name()))
        << sample.name;
  }
  fs::remove_all(project);
}

TEST(MakeSamples, AppliesThePatch) {
  const fs::path project = small_project("one\n");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_EQ(hair::bytes_of(project / "class" / "bug" / "a.cpp"), "two\n");
}

TEST(MakeSamples, CopiesWhatIsMarkedToTheShowcase) {
  const fs::path project = small_project("one\n"), out = project / "class", showcase = project / "showcase";
  add_sample(project, "shown",
             R"("form": "folder", "files": {"src/a.cpp": "plain"}, "showcase": true,
                "expect": {"A": {"status": "passed"}})");
  const Outcome run = make_samples(project, out, showcase);
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_EQ(hair::bytes_of(showcase / "shown" / "src" / "a.cpp"), "one\n");
  EXPECT_FALSE(fs::exists(showcase / "bug"));
  EXPECT_TRUE(fs::exists(out / "bug"));
}

TEST(MakeSamples, PacksAttacksByPlaceAndApartFromTheClass) {
  const fs::path project = small_project("one\n"), out = project / "class",
                 attacks = project / "class-attacks";
  add_sample(project, "attacks",
             R"("form": "folder", "files": {"a.cpp": "plain"}, "expect": {"A": {"status": "wrong"}},
                "attack": {"place": "start", "fence": "A wall.", "most_points": 2, "most_cpu_seconds": 1})");
  std::ofstream(project / "grader" / "samples" / "list" / "right.json")
      << R"({"samples": [{"name": "honest", "shows": "It.", "form": "folder", "files": {"a.cpp": "plain"},
             "beside_attacks": true, "expect": {"A": {"status": "passed"}}}]})";
  const Outcome run = make_samples(project, out);
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_FALSE(fs::exists(out / "attacks"));
  EXPECT_TRUE(fs::exists(attacks / "start" / "attacks"));
  EXPECT_FALSE(fs::exists(attacks / "run" / "attacks"));
  for (const char* place : kPlaces) EXPECT_TRUE(fs::exists(attacks / place / "honest")) << place;
  EXPECT_TRUE(fs::exists(out / "honest"));
}

TEST(MakeSamples, OverwritesBytesFromBothEnds) {
  const fs::path project = small_project("one\n"), out = project / "class";
  const std::string sample =
      R"("form": "zip", "files": {"a.cpp": "plain"}, "expect": {"A": {"status": "passed"}})";
  add_sample(project, "forged",
             sample + R"(, "overwrite": [{"at": 0, "hex": "00ff"}, {"at": -2, "hex": "fe"}])");
  Outcome run = make_samples(project, out);
  EXPECT_EQ(run.code, 0) << run.output;
  const std::string bytes = hair::bytes_of(out / "forged.zip");
  EXPECT_EQ(bytes.substr(0, 2), std::string("\0\xff", 2));
  EXPECT_EQ(bytes.substr(bytes.size() - 2, 1), "\xfe");
  add_sample(project, "forged", sample + R"(, "overwrite": [{"at": 100000, "hex": "00"}])");
  run = make_samples(project, out);
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("nothing to overwrite at 100000"), std::string::npos) << run.output;
}

TEST(MakeSamples, RefusesAPatchThatDoesNotApply) {
  const fs::path project = small_project("three\n");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("bug.patch does not apply"), std::string::npos) << run.output;
  EXPECT_FALSE(fs::exists(project / "class"));
}

TEST(MakeSamples, RefusesAPatchThatNoSampleUses) {
  const fs::path project = small_project("one\n");
  std::ofstream(project / "grader" / "samples" / "patches" / "forgotten.patch") << "";
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("forgotten.patch: no sample uses it"), std::string::npos) << run.output;
}

TEST(MakeSamples, NamesASolutionThatIsNotThere) {
  const fs::path project = small_project("one\n");
  fs::remove(project / "grader" / "samples" / "solutions" / "plain" / "a.cpp");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("sample \"bug\": a.cpp: "), std::string::npos) << run.output;
}

TEST(MakeSamples, FillsInTheOtherExercises) {
  const fs::path project = small_project("one\n"), out = project / "class";
  for (const auto& [others, bytes] : {std::pair("stub", "stub\n"), std::pair("reference", "reference\n")}) {
    add_sample(project, "more",
               R"("form": "folder", "files": {"src/a.cpp": "plain"}, "others": ")" + std::string(others) +
                   R"(", "expect": {"A": {"status": "passed"}})");
    const Outcome run = make_samples(project, out);
    EXPECT_EQ(run.code, 0) << run.output;
    EXPECT_EQ(hair::bytes_of(out / "more" / "b.cpp"), bytes);
    EXPECT_EQ(hair::bytes_of(out / "more" / "src" / "a.cpp"), "one\n");
  }
}

TEST(ReadSamples, ReadsPointsAndLeavesThemOpen) {
  const auto samples = read_samples(small_project("one\n"));
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(samples[0].expected.at("A").status, "wrong");
  EXPECT_EQ(samples[0].expected.at("A").points, 3.0);
  EXPECT_EQ(samples[0].expected.at("B").points, std::nullopt);
  EXPECT_EQ(samples[0].list, "bugs");
  EXPECT_FALSE(samples[0].showcase);
}

TEST(ReadSamples, ReadsAttacks) {
  const fs::path project = small_project("one\n");
  add_sample(project, "attacks",
             R"("form": "zip", "files": {}, "expect": {},
                "attack": {"place": "start", "fence": "A wall.", "most_points": {"A": 2}, "most_cpu_seconds": 1.5,
                           "also": ["crashed"], "no_pictures": true})");
  const std::vector<Sample> samples = read_samples(project);
  ASSERT_TRUE(samples.at(1).attack.has_value());
  const Attack& attack = *samples[1].attack;
  EXPECT_EQ(attack.place, "start");
  EXPECT_EQ(attack.fence, "A wall.");
  EXPECT_EQ(attack.most_points_of.at("A"), 2);
  EXPECT_EQ(attack.most_points, std::nullopt);
  EXPECT_EQ(attack.most_cpu_seconds, 1.5);
  EXPECT_EQ(attack.also, std::vector<std::string>{"crashed"});
  EXPECT_TRUE(attack.no_pictures);
  EXPECT_FALSE(samples[1].in_class());
  EXPECT_FALSE(samples[0].attack.has_value());
  add_sample(project, "attacks",
             R"("form": "zip", "files": {}, "expect": {}, "showcase": true,
                "attack": {"place": "run", "fence": "A wall.", "most_points": 7, "most_cpu_seconds": 1})");
  EXPECT_EQ(read_samples(project).at(1).attack->most_points, 7.0);
  EXPECT_TRUE(read_samples(project)[1].in_class());
}

TEST(ReadSamples, ReadsTheListsInTheOrderOfTheirNames) {
  const fs::path project = small_project("one\n");
  add_sample(project, "more", R"("form": "zip", "files": {}, "expect": {})");
  const auto samples = read_samples(project);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].name, "bug");
  EXPECT_EQ(samples[1].name, "more");
}

TEST(ReadSamples, ExpectsWhatIsNeitherListedNorFilledInToBeMissing) {
  const fs::path project = small_project("one\n");
  EXPECT_EQ(read_samples(project)[0].expected.at("B").status, "missing");
  EXPECT_EQ(read_samples(project)[0].listed, std::vector<std::string>{"A"});
  add_sample(project, "more", R"("form": "zip", "files": {}, "others": "reference", "expect": {})");
  EXPECT_EQ(read_samples(project)[1].expected.at("B").status, "passed");
  add_sample(project, "more", R"("form": "zip", "files": {}, "others": "stub", "expect": {})");
  EXPECT_EQ(read_samples(project)[1].expected.at("B").status, "not implemented");
}

TEST(ReadSamples, NamesWhatIsNotRight) {
  const fs::path project = small_project("one\n");
  add_sample(project, "more", R"("form": "rar", "files": {}, "expect": {})");
  expect_refused(project, "more.json: samples[0].form: unknown form; write zip");
  add_sample(project, "bug", R"("form": "zip", "files": {}, "expect": {})");
  expect_refused(project, "samples[0].name: this name is taken");
  add_sample(project, "more", R"("form": "zip", "files": {}, "others": "plain", "expect": {})");
  expect_refused(project, "samples[0].others: write reference or stub");
  add_sample(project, "more", R"("form": "zip", "files": {}, "expect": {"C": {"status": "passed"}})");
  expect_refused(project, "samples[0].expect: there is no exercise C");
  add_sample(project, "more", R"("form": "zip", "files": {"b/b.cpp": "stub"}, "expect": {})");
  expect_refused(project, "samples[0].expect: does not say what B gets for its b.cpp");
  add_sample(project, "more",
             R"("form": "zip", "files": {}, "others": "stub", "expect": {"A": {"status": "passed"}})");
  expect_refused(project, "samples[0].expect: names A, which \"others\" fills in");
  add_sample(project, "more",
             R"("form": "zip", "files": {}, "expect": {"A": {"status": "partly", "points": 6}})");
  expect_refused(project, "samples[0].expect.A.points: 6 is not right; give a number from 0 to 5");
  add_sample(project, "more", R"("form": "zip", "files": {}, "showcase": "yes", "expect": {})");
  expect_refused(project, "samples[0].showcase: ");
  const std::string attack =
      R"("form": "zip", "files": {}, "expect": {}, "attack": {"fence": "A wall.", "most_cpu_seconds": 1, )";
  add_sample(project, "more", attack + R"("place": "nowhere", "most_points": 0})");
  expect_refused(project, "samples[0].attack.place: unknown place; write build, ");
  add_sample(project, "more", attack + R"("place": "run", "most_points": {"C": 0}})");
  expect_refused(project, "samples[0].attack.most_points: there is no exercise C");
  add_sample(project, "more", attack + R"("place": "run"})");
  expect_refused(project, "most_points");
  add_sample(project, "more",
             R"("form": "zip", "files": {}, "expect": {}, "overwrite": [{"at": 1, "hex": "0"}])");
  expect_refused(project, "samples[0].overwrite[0].hex: write two digits");
}

}  // namespace
}  // namespace grader

// STAFF ONLY. hairgrade as a person meets it: options, errors, reruns, interruptions.
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "grader/tests/run_program.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;

class Hairgrade : public testing::Test {
 protected:
  Hairgrade() {
    string pattern = (fs::temp_directory_path() / "hairgrade-test-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    std::ofstream(folder_ / "secret") << "a secret for this test";
  }
  ~Hairgrade() override { fs::remove_all(folder_); }

  string sample(const string& name) const { return (fs::path(HAIR_SAMPLE_CLASS) / name).string(); }
  string out() const { return (folder_ / "grades").string(); }

  ProgramRun grade(std::vector<string> arguments, const std::function<void(int)>& meanwhile = {}) const {
    arguments.insert(arguments.begin(), "grade");
    for (const char* word : {"--secret", "secret", "--cache", "cache"})
      arguments.push_back(word[0] == '-' ? string(word) : (folder_ / word).string());
    return run_hairgrade(arguments, meanwhile);
  }

  // Bad input: exit code 2, one line that holds these words, and nothing written.
  void expect_refused(const ProgramRun& run, const std::vector<string>& words) const {
    EXPECT_EQ(run.code, 2) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    for (const string& word : words)
      EXPECT_NE(run.errors.find(word), string::npos) << "no \"" << word << "\" in: " << run.errors;
    EXPECT_FALSE(fs::exists(out()));
  }

  string write(const string& name, const string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  std::map<string, string> files(const fs::path& folder) const {
    std::map<string, string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) all[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
    return all;
  }

  fs::path folder_;
};

TEST_F(Hairgrade, RefusesBadUsageInOneLine) {
  expect_refused(run_hairgrade({}), {"--help"});
  expect_refused(run_hairgrade({"grade"}), {"SUBMISSION", "--help"});
  expect_refused(run_hairgrade({"degrade"}), {"degrade", "grade, compare and handout"});
  expect_refused(grade({sample("other-order.tar.gz")}), {"--out"});
  expect_refused(grade({sample("other-order.tar.gz"), "--out", out(), "--quickly"}), {"--quickly"});
  for (const char* jobs : {"0", "-1", "many", "1e9"})
    expect_refused(grade({sample("other-order.tar.gz"), "--out", out(), "-j", jobs}), {"-j"});
  EXPECT_EQ(run_hairgrade({"--help"}).code, 0);
}

TEST_F(Hairgrade, RefusesSubmissionsThatAreNone) {
  expect_refused(grade({"/no/such/file.zip", "--out", out()}), {"/no/such/file.zip"});
  expect_refused(grade({write("notes.txt", "hello"), "--out", out()}), {"notes.txt"});
  fs::create_directory(folder_ / "empty");
  expect_refused(grade({(folder_ / "empty").string(), "--out", out()}), {"empty"});
}

TEST_F(Hairgrade, RefusesTwoSubmissionsOfOneName) {
  fs::create_directory(folder_ / "late");
  fs::copy_file(sample("other-order.tar.gz"), folder_ / "late" / "other-order.tar.gz");
  expect_refused(grade({sample("other-order.tar.gz"), (folder_ / "late" / "other-order.tar.gz").string(),
                        "--out", out()}),
                 {sample("other-order.tar.gz"), (folder_ / "late" / "other-order.tar.gz").string()});
}

TEST_F(Hairgrade, RefusesBadCourseFiles) {
  const string submission = sample("other-order.tar.gz");
  const std::map<string, std::vector<string>> bad = {
      {"{", {"course.json"}},
      {R"({"exercises": {"S9": {"role": "given"}}})", {"course.json", "S9"}},
      {R"({"exercises": {"S1": {"role": "homework"}}})", {"course.json", "S1.role", "assigned"}},
      {R"({"exercises": {"S1": {"points": -1}}})", {"course.json", "points"}},
      {R"({"exercises": {"S1": {"role": "absent"}}})", {"S2", "S1"}},
      {R"({"exercise": {}})", {"course.json", "exercise"}}};
  for (const auto& [text, words] : bad) {
    SCOPED_TRACE(text);
    expect_refused(grade({submission, "--out", out(), "--course", write("course.json", text)}), words);
  }
  expect_refused(grade({submission, "--out", out(), "--course", "/no/course.json"}), {"/no/course.json"});
}

TEST_F(Hairgrade, RefusesExercisesAndNamesThatAreNotThere) {
  expect_refused(grade({sample("other-order.tar.gz"), "--out", out(), "--exercise", "X1"}),
                 {"X1", "S1, S2, P1, P2, H1, H2, H3, H4, H5, H6"});
  const string given = write("course.json", R"({"exercises": {"S1": {"role": "given"}}})");
  expect_refused(grade({sample("other-order.tar.gz"), "--out", out(), "--exercise", "S1", "--course", given}),
                 {"S1"});
  expect_refused(grade({sample("other-order.tar.gz"), "--out", out(), "--only", "alice"}),
                 {"alice", "other-order"});
}

TEST_F(Hairgrade, RefusesAShortOrMissingSecret) {
  const string short_secret = write("short", "123");
  expect_refused(
      run_hairgrade({"grade", sample("other-order.tar.gz"), "--out", out(), "--secret", short_secret}),
      {"short", "16"});
  expect_refused(
      run_hairgrade({"grade", sample("other-order.tar.gz"), "--out", out(), "--secret", "/no/secret"}),
      {"/no/secret"});
}

TEST_F(Hairgrade, RefusesAnOutputThatIsAFile) {
  const string file = write("file", "not a folder");
  const ProgramRun run = grade({sample("other-order.tar.gz"), "--out", file});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.errors.find(file), string::npos) << run.errors;
  EXPECT_EQ(read_file(file), "not a folder");
}

TEST_F(Hairgrade, RefusesAHandoutThatCanNotBeWritten) {
  const ProgramRun run = run_hairgrade({"handout", "--out", "/no/such/folder/handout.tar.gz"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.errors.find("/no/such/folder"), string::npos) << run.errors;
}

TEST_F(Hairgrade, GivesTheSameBytesAgain) {
  const std::vector<string> class_of_four = {sample("other-order.tar.gz"), sample("stubs.zip"),
                                             sample("wrong-beta.zip"), sample("segfault.zip")};
  std::vector<string> present;
  for (const string& archive : class_of_four)
    for (const char* ending : {"", ".zip", ".tar.gz"}) {
      const string path =
          fs::path(archive).parent_path() / (fs::path(archive).stem().stem().string() + ending);
      if (fs::exists(path)) present.push_back(path);
    }
  ASSERT_EQ(present.size(), class_of_four.size());
  auto once = [&](const string& where, const char* jobs) {
    std::vector<string> arguments = present;
    for (const string& word : {string("--out"), (folder_ / where).string(), string("-j"), string(jobs)})
      arguments.push_back(word);
    const ProgramRun run = grade(arguments);
    EXPECT_EQ(run.code, 0) << run.errors;
    std::map<string, string> all = files(folder_ / where);
    EXPECT_EQ(all.erase("timing.json"), 1U);
    return all;
  };
  const std::map<string, string> first = once("first", "1"), second = once("second", "2");
  EXPECT_EQ(first.size(), second.size());
  for (const auto& [name, bytes] : first)
    EXPECT_TRUE(second.count(name) > 0 && second.at(name) == bytes) << name;
}

TEST_F(Hairgrade, ResumesWhatHasNotChanged) {
  ASSERT_EQ(grade({sample("other-order.tar.gz"), "--out", out()}).code, 0);
  const auto before = fs::last_write_time(fs::path(out()) / "other-order" / "results.json");
  const ProgramRun again = grade({sample("other-order.tar.gz"), "--out", out(), "--resume"});
  EXPECT_NE(again.output.find("0 graded, 1 kept"), string::npos) << again.output;
  EXPECT_EQ(fs::last_write_time(fs::path(out()) / "other-order" / "results.json"), before);
  // Another secret is another suite.
  write("secret", "quite another secret");
  EXPECT_NE(grade({sample("other-order.tar.gz"), "--out", out(), "--resume"}).output.find("1 graded"),
            string::npos);
}

TEST_F(Hairgrade, GradesOneExerciseAlone) {
  ASSERT_EQ(grade({sample("other-order.tar.gz"), "--out", out(), "--exercise", "S2"}).code, 0);
  const nlohmann::json results =
      nlohmann::json::parse(read_file(fs::path(out()) / "other-order" / "results.json"));
  EXPECT_EQ(results.at("score"), 20);
  for (const nlohmann::json& test : results.at("tests")) EXPECT_EQ(test.at("tags").at(0), "S2");
}

TEST_F(Hairgrade, KeepsTheOtherExercisesOfAnEarlierRun) {
  ASSERT_EQ(grade({sample("other-order.tar.gz"), "--out", out()}).code, 0);
  ASSERT_EQ(grade({sample("other-order.tar.gz"), "--out", out(), "--exercise", "S1"}).code, 0);
  EXPECT_EQ(nlohmann::json::parse(read_file(fs::path(out()) / "other-order" / "results.json")).at("score"),
            52);
}

TEST_F(Hairgrade, KeepsNoObjectThatWasCompiledWithoutASandbox) {
  // Outside of the sandbox the staff's files can be included; that object must not serve a run inside.
  fs::create_directory(folder_ / "thief");
  std::ofstream(folder_ / "thief" / "conj_grad.cpp")
      << "#include \"" HAIR_PROJECT "/reference/conj_grad.cpp\"\n";
  const string thief = (folder_ / "thief").string();
  auto score = [&] {
    return nlohmann::json::parse(read_file(fs::path(out()) / "thief" / "results.json")).at("score");
  };
  ASSERT_EQ(grade({thief, "--out", out(), "--unsafe-no-sandbox"}).code, 0);
  EXPECT_EQ(score(), 32);
  ASSERT_EQ(grade({thief, "--out", out()}).code, 0);
  EXPECT_EQ(score(), 0);
}

TEST_F(Hairgrade, TakesPointsAndRolesFromTheCourse) {
  const string course = write(
      "course.json", R"({"exercises": {"S1": {"points": 60}, "S2": {"role": "optional", "points": 5}}})");
  ASSERT_EQ(grade({sample("other-order.tar.gz"), "--out", out(), "--course", course}).code, 0);
  EXPECT_EQ(nlohmann::json::parse(read_file(fs::path(out()) / "other-order" / "results.json")).at("score"),
            65);
}

TEST_F(Hairgrade, KeepsWhatIsFinishedWhenInterrupted) {
  fs::create_directory(folder_ / "class");
  auto add = [&](const string& name) {
    for (const char* ending : {".zip", ".tar.gz"})
      if (fs::exists(sample(name) + ending))
        fs::copy_file(sample(name) + ending, folder_ / "class" / (name + ending));
  };
  const string everybody = (folder_ / "class").string();
  add("stubs");
  ASSERT_EQ(grade({everybody, "--out", out()}).code, 0);
  // One at a time: `other-order` is graded at once, `sleeps` sleeps until the watchdog comes, and `stubs` is not
  // reached.
  add("other-order");
  add("sleeps");
  const fs::path first = fs::path(out()) / "other-order" / "results.json";
  const ProgramRun run = grade({everybody, "--out", out(), "-j", "1"}, [&](int process) {
    for (int i = 0; i < 400 && !fs::exists(first); ++i) usleep(50000);
    kill(process, SIGINT);
  });
  EXPECT_EQ(run.code, 130) << run.errors;
  EXPECT_NE(run.errors.find("--resume"), string::npos) << run.errors;
  EXPECT_EQ(nlohmann::json::parse(read_file(first)).at("score"), 52);
  EXPECT_FALSE(fs::exists(fs::path(out()) / "sleeps"));
  const string gradebook = read_file(fs::path(out()) / "grades.csv");
  EXPECT_NE(gradebook.find("other-order,52"), string::npos) << gradebook;
  EXPECT_NE(gradebook.find("stubs,0"), string::npos) << gradebook;
}

TEST_F(Hairgrade, StampsWhatWasGradedWithoutASandbox) {
  ASSERT_EQ(grade({sample("other-order.tar.gz"), "--out", out(), "--unsafe-no-sandbox"}).code, 0);
  EXPECT_NE(read_file(fs::path(out()) / "other-order" / "report.html").find("without a sandbox"),
            string::npos);
  EXPECT_NE(read_file(fs::path(out()) / "index.html").find("without a sandbox"), string::npos);
  EXPECT_EQ(nlohmann::json::parse(read_file(fs::path(out()) / "other-order" / "results.json")).at("score"),
            52);
}

TEST_F(Hairgrade, WithoutImagesTheOtherCategoriesHaveTheirPoints) {
  const std::vector<string> submission = {sample("other-order.tar.gz"), "--out", out()};
  ASSERT_EQ(grade(submission).code, 0);
  const fs::path results = fs::path(out()) / "other-order" / "results.json";
  const auto numbers = [&] {
    std::map<string, double> points;
    const nlohmann::json document = nlohmann::json::parse(read_file(results));
    for (const nlohmann::json& test : document.at("tests"))
      if (test.at("tags").at(0) == "S1") points[test.at("name")] = test.at("max_score");
    return points;
  };
  const std::map<string, double> with = numbers();
  EXPECT_EQ(with.at("Pictures of it"), 1);
  std::vector<string> without_images = submission;
  without_images.insert(without_images.end(), {"--no-images", "--resume"});
  // Another result, which --resume must not keep.
  EXPECT_NE(grade(without_images).output.find("1 graded, without pictures"), string::npos);
  std::map<string, double> without = numbers();
  EXPECT_EQ(without.count("Pictures of it"), 0U);
  EXPECT_EQ(without.size() + 1, with.size());
  for (const auto& [name, points] : without) EXPECT_NEAR(points, with.at(name) * 32 / 31, 1e-3) << name;
  EXPECT_EQ(nlohmann::json::parse(read_file(results)).at("score"), 52);
  for (const char* page : {"other-order/report.html", "index.html"})
    EXPECT_NE(read_file(fs::path(out()) / page).find("without pictures"), string::npos) << page;
  EXPECT_NE(grade({submission[0], "--out", out(), "--resume"}).output.find("1 graded"), string::npos);
}

TEST_F(Hairgrade, KeepsTheReferencesPicturesForTheNextBatch) {
  const auto kept = [&] {
    std::map<string, fs::file_time_type> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache" / "pictures"))
      if (entry.is_regular_file()) all[entry.path().string()] = entry.last_write_time();
    return all;
  };
  ASSERT_EQ(grade({sample("other-order.tar.gz"), "--out", out()}).code, 0);
  const auto first = kept();
  EXPECT_GE(first.size(), 9U * 3);
  ASSERT_EQ(grade({sample("other-order.tar.gz"), "--out", out()}).code, 0);
  EXPECT_EQ(kept(), first);
}

TEST_F(Hairgrade, WritesTheHandout) {
  const string archive = (folder_ / "handout.tar.gz").string();
  const ProgramRun run = run_hairgrade({"handout", "--out", archive});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_GT(fs::file_size(archive), 1000U);
}

}  // namespace
}  // namespace grader

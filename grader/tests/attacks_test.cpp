// STAFF ONLY. Grades the attack corpus place by place, and tests each attack's points and costs, and that it
// reaches no other submission. The environment's HAIR_PLACE names the place, and HAIR_ISOLATION the kind of
// isolation. Results are kept: an interrupted test goes on, as long as hairgrade and its suite are the same.
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/intake/names/names.h"
#include "grader/record/record.h"
#include "grader/result/result.h"
#include "grader/samples/sample.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/base64.h"
#include "hair/io/files/read_file.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using tests::says;

// Attacks print, throw or claim this text in a worker.
const std::string kMarker = "hair-attack-says";

std::string set_in(const char* variable, const char* such_as) {
  const std::string word = environment(variable, "");
  if (word.empty())
    throw std::runtime_error(std::string(variable) + " is not set: name one, such as " + such_as);
  return word;
}

std::string place() {
  return set_in("HAIR_PLACE", "run");
}

std::string isolation() {
  return set_in("HAIR_ISOLATION", to_string(Isolation::namespaces));
}

fs::path folder() {
  return fs::path(HAIR_GRADED) / "attacks" / isolation() / place();
}

fs::path grades() {
  return folder() / "grades";
}

std::vector<Sample> corpus() {
  std::vector<Sample> all = read_samples(HAIR_PROJECT);
  std::erase_if(all, [](const Sample& sample) { return !sample.graded_at(place()); });
  return all;
}

double cpu_seconds_of_children() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

struct ShardRun {
  int code = 0;
  double cpu_seconds = 0;  // sums all processes that it started and that have ended
  int left_behind = 0;     // counts processes that still ran long after its end
};

// The output is added to the file `terminal`. This process adopts processes that hairgrade leaves behind, so
// that it can measure their time and see their end.
ShardRun run_shard(const std::vector<std::string>& words, const fs::path& terminal) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const double before = cpu_seconds_of_children();
  ShardRun run;
  // A test that runs out of time leaves nothing running.
  run.code = run_hairgrade(words, {},
                           "exec >>'" + terminal.string() + "' 2>&1 setpriv --pdeathsig TERM \"$0\" \"$@\"")
                 .code;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(10);
  for (;;) {
    const pid_t ended = waitpid(-1, nullptr, WNOHANG);
    if (ended < 0) break;  // there is no child any more
    if (ended > 0) continue;
    if (std::chrono::steady_clock::now() > deadline) {
      ++run.left_behind;
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  run.cpu_seconds = cpu_seconds_of_children() - before;
  return run;
}

// Describes the parts that --resume does not compare: hairgrade and its suite.
std::string version() {
  std::string all;
  for (const char* program : {HAIRGRADE, HAIR_SUITE_PROGRAM})
    all += std::to_string(std::hash<std::string>()(hair::bytes_of(program))) + "\n";
  return all + hair::bytes_of(HAIR_ATTACKS_COURSE);
}

class AttackCorpus : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!skipped().empty()) return;
    if (hair::bytes_of(folder() / "version") != version()) fs::remove_all(folder());
    fs::create_directories(folder());
    std::ofstream(folder() / "version") << version();
    std::vector<std::string> words = {
        "grade",       (fs::path(HAIR_ATTACKS) / place()).string(),
        "--out",       grades().string(),
        "--cache",     (folder() / "cache").string(),
        "--isolation", isolation(),
        "--secret",    HAIR_TEST_SECRET,
        "--course",    HAIR_ATTACKS_COURSE,  // has a smaller budget: it takes minutes
        "--resume"};
    run_ = run_shard(words, folder() / "terminal");
    timing_ = json::parse(hair::bytes_of(grades() / "timing.json"), nullptr, false);
  }

  // The container's tests never skip.
  static std::string skipped() {
    return isolation() == to_string(Isolation::namespaces) ? why_not(Isolation::namespaces) : "";
  }
  void SetUp() override {
    if (!skipped().empty()) GTEST_SKIP() << skipped();
  }

  static SubmissionResult result_of(const Sample& sample) {
    return recorded_result(grades(), submission_name(sample.name)).value();
  }

  inline static ShardRun run_;
  inline static json timing_;
};

// Reads both files for a student.
std::vector<std::string> pages_of(const Sample& sample) {
  const fs::path of = grades() / submission_name(sample.name);
  return {hair::bytes_of(of / "report.html"), hair::bytes_of(of / "results.json")};
}

// Finds control characters except line feeds and tabs, in UTF-8 or not: terminals obey them.
bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return (byte < 0x20 && letter != '\n' && letter != '\t') || byte == 0x7f;
  });
}

// No attack makes the grader itself fail.
TEST_F(AttackCorpus, IsGradedToItsEnd) {
  EXPECT_TRUE(run_.code == 0 || run_.code == 3) << run_.code << "; 3: a person must look at some";
  const std::string terminal = hair::bytes_of(folder() / "terminal");
  const std::size_t trouble = terminal.find("could not grade");
  if (trouble != std::string::npos) {
    ADD_FAILURE() << printable(terminal.substr(trouble, 400), 400);
  }
  for (const Sample& sample : corpus())
    EXPECT_TRUE(fs::exists(grades() / submission_name(sample.name) / "report.html")) << sample.name;
}

TEST_F(AttackCorpus, GetsItsStatuses) {
  for (const Sample& sample : corpus()) {
    SCOPED_TRACE(sample.name + ": " + sample.shows);
    for (const ExerciseResult& exercise : result_of(sample).exercises) {
      const ExpectedResult& expected = sample.expected.at(exercise.id);
      const std::string status = to_string(exercise.status);
      const bool attacked = sample.attack && (sample.attack->most_points ||
                                              sample.attack->most_points_of.count(exercise.id) > 0);
      const bool also = attacked && std::ranges::count(sample.attack->also, status) > 0;
      EXPECT_TRUE(status == expected.status || also)
          << exercise.id << " " << status << ", expected: " << expected.status << "\n"
          << printable(exercise.staff_log.substr(0, 300), 300);
    }
  }
}

TEST_F(AttackCorpus, GetsNoMorePointsThanItMay) {
  for (const Sample& sample : corpus()) {
    if (!sample.attack) continue;
    SCOPED_TRACE(sample.name + ": " + sample.shows);
    double points = 0;
    for (const ExerciseResult& exercise : result_of(sample).exercises) {
      points += exercise.points;
      const auto most = sample.attack->most_points_of.find(exercise.id);
      if (most == sample.attack->most_points_of.end()) continue;
      EXPECT_LE(exercise.points, most->second) << exercise.id;
    }
    if (sample.attack->most_points) {
      EXPECT_LE(points, *sample.attack->most_points);
    }
  }
}

TEST_F(AttackCorpus, CostsNobodyBesideItAnything) {
  int honest = 0;
  for (const Sample& sample : corpus()) {
    if (sample.attack) continue;
    SCOPED_TRACE(sample.name);
    for (const ExerciseResult& exercise : result_of(sample).exercises)
      if (sample.expected.at(exercise.id).status == "passed") {
        EXPECT_EQ(exercise.points, exercise.max_points) << exercise.id;
        ++honest;
      }
  }
  EXPECT_GE(honest, 2);
}

// Compiling the reference's files next to an attack takes time in every submission.
bool has_reference(const Sample& sample, const Course& course, const std::string& exercise) {
  return !sample.attack->most_points_of.contains(exercise) &&
         std::ranges::any_of(sample.files, [&](const SampleFile& file) {
           const Exercise* of = course.find(exercise);
           return of != nullptr && file.path == of->file && file.kind == SampleFile::Kind::solution &&
                  file.value == "reference";
         });
}

// Bounds CPU seconds alone: a busy machine takes longer by wall time.
TEST_F(AttackCorpus, TakesNoMoreTimeThanItMay) {
  ASSERT_TRUE(timing_.is_object());
  const Course course =
      read_course(fs::path(HAIR_PROJECT) / "handout" / "exercises.json", HAIR_ATTACKS_COURSE);
  double bounds = 0;
  for (const Sample& sample : corpus()) {
    if (!sample.attack) continue;
    bounds += sample.attack->most_cpu_seconds;
    double seconds = 0, idle = 0;
    const json& exercises = timing_.at("submissions").at(submission_name(sample.name));
    for (const auto& [exercise, times] : exercises.items()) {
      seconds += times.at("picture_cpu_seconds").get<double>();
      for (const auto& [key, value] : times.items())
        if (key.starts_with("spent_") && key.ends_with("cpu_seconds") &&
            !(key == "spent_compiler_cpu_seconds" && has_reference(sample, course, exercise)))
          seconds += value.get<double>();
      idle += times.at("spent_idle_seconds").get<double>();
    }
    // The watchdog looks at a worker four times a second. A compiler that is stopped at its limit then frees
    // its memory.
    const double stops = static_cast<double>(exercises.size());
    EXPECT_LE(idle, course.budget.idle_seconds + 0.25 * stops) << sample.name;
    EXPECT_LE(seconds, sample.attack->most_cpu_seconds + 0.1 * stops)
        << sample.name << ": " << sample.shows << "\n"
        << exercises;
  }
  // Adds parts without a file: hairgrade and its suite, and the reference's files, which are compiled once in
  // each build. The reference and right submissions take less than a minute.
  EXPECT_LE(run_.cpu_seconds, bounds + 60);
  RecordProperty("cpu_seconds", std::to_string(run_.cpu_seconds));
}

TEST_F(AttackCorpus, LeavesNothingRunning) {
  EXPECT_EQ(run_.left_behind, 0);
}

TEST_F(AttackCorpus, ChangesNothingOutsideOfTheSandbox) {
  EXPECT_EQ(traces({grades(), HAIR_ATTACKS}), std::vector<fs::path>());
}

TEST_F(AttackCorpus, ChangesNoTerminal) {
  const std::string terminal = hair::bytes_of(folder() / "terminal");
  EXPECT_FALSE(terminal.empty());
  for (std::size_t at = 0, end = 0; at < terminal.size(); at = end + 1) {
    end = std::min(terminal.find('\n', at), terminal.size());
    // Progress may return to the line's beginning.
    std::string line = terminal.substr(at, end - at);
    std::erase(line, '\r');
    EXPECT_FALSE(has_control_characters(line)) << printable(line, 300);
  }
}

TEST_F(AttackCorpus, SaysNothingOnAStudentsPage) {
  for (const Sample& sample : corpus())
    for (const std::string& page : pages_of(sample)) {
      EXPECT_FALSE(page.empty()) << sample.name;
      const std::size_t at = page.find(kMarker);
      if (at != std::string::npos) {
        ADD_FAILURE() << sample.name << ": " << printable(page.substr(at < 200 ? 0 : at - 200, 300), 300);
      }
    }
}

// The staff's pages have none either.
TEST_F(AttackCorpus, WritesNoMarkupAndNoControlCharacters) {
  for (const Sample& sample : corpus()) {
    const fs::path staff = grades() / "staff" / (submission_name(sample.name) + ".html");
    for (const std::string& page : {pages_of(sample).at(0), hair::bytes_of(staff)})
      for (const char* markup : {"<script>document", "<script>alert", "<img src=x"})
        EXPECT_FALSE(says(page, markup)) << sample.name << ": ";
    std::vector<std::string> all = pages_of(sample);
    all.push_back(hair::bytes_of(staff));
    for (const std::string& page : all) EXPECT_FALSE(has_control_characters(page)) << sample.name;
  }
}

TEST_F(AttackCorpus, ShowsNoPictureThatItMustNot) {
  for (const Sample& sample : corpus()) {
    if (!sample.attack || !sample.attack->no_pictures) continue;
    const std::string page = pages_of(sample).at(0);
    const SubmissionResult result = result_of(sample);
    const auto check = [&](const std::vector<PictureResult>& pictures) {
      for (const PictureResult& picture : pictures) {
        if (picture.student.empty() || picture.student == picture.reference) continue;
        EXPECT_FALSE(says(page, hair::base64(picture.student))) << sample.name << ", " << picture.name;
      }
    };
    for (const ExerciseResult& exercise : result.exercises) check(exercise.pictures);
  }
}

}  // namespace
}  // namespace grader

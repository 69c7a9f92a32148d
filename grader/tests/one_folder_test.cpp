// STAFF ONLY. Tests several graders of one folder of grades: they start at once, are killed, or grade by
// other rules.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <latch>
#include <map>
#include <stdexcept>
#include <thread>

#include "grader/record/record.h"
#include "grader/sandbox/processes/descriptor.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;

constexpr const char* kWaiting = " is in use by another hairgrade; waiting until it has finished\n";

int lines_with(const string& text, const string& words) {
  int lines = 0;
  for (std::size_t at = text.find(words); at != string::npos; at = text.find(words, at + 1)) ++lines;
  return lines;
}

// Grades S2 alone and without pictures, so that a submission takes a second.
class OneFolder : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    common_ = new hair::TemporaryFolder("one-folder");
    write("secret", "a secret for this test");
    write("course.json", R"({"exercises": {"H6": {"role": "absent"}}})");
  }
  static void TearDownTestSuite() { delete common_; }

  static string write(const string& name, const string& text) {
    std::ofstream(common_->path() / name) << text;
    return (common_->path() / name).string();
  }
  static ProgramRun grade(const std::vector<string>& samples, const fs::path& out,
                          std::vector<string> options = {},
                          const std::function<void(const RunningProgram&)>& meanwhile = {}) {
    std::vector<string> words = {"grade", "--out", out.string(), "--exercise", "S2", "--no-images"};
    for (const string& name : samples) words.push_back(sample(name));
    const auto add = [&](const string& option, const string& value) {
      if (std::ranges::count(options, option) == 0) words.insert(words.end(), {option, value});
    };
    add("--secret", (common_->path() / "secret").string());
    add("--cache", (common_->path() / "cache").string());
    add("--course", (common_->path() / "course.json").string());
    words.insert(words.end(), options.begin(), options.end());
    return run_hairgrade(words, meanwhile);
  }
  // Reads all files except times and the record, which has times, too.
  static std::map<string, string> files(const fs::path& folder) {
    std::map<string, string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().filename() != kRecordFile)
        all[fs::relative(entry.path(), folder).string()] = hair::bytes_of(entry.path());
    EXPECT_EQ(all.erase("timing.json") + all.erase("costs.html"), 2U);
    return all;
  }
  static void expect_same(const fs::path& found, const fs::path& expected) {
    const std::map<string, string> a = files(found), b = files(expected);
    for (const auto& [name, bytes] : b) EXPECT_TRUE(a.contains(name) && a.at(name) == bytes) << name;
    for (const auto& [name, bytes] : a) EXPECT_TRUE(b.contains(name)) << name;
  }

  inline static hair::TemporaryFolder* common_ = nullptr;
  hair::TemporaryFolder temporary_{"one-folder"};
  fs::path out_ = temporary_.path() / "grades";
};

// The first grader is stopped after one of three submissions while the others start; then it is killed.
TEST_F(OneFolder, FourAtOnceOfWhichOneIsKilledLoseNothing) {
  const std::vector<string> first = {"other-order", "perfect", "textbook"};
  const std::array<string, 3> others = {"stubs", "segfault", "prints-success"};
  std::array<ProgramRun, 3> runs;
  std::latch all_wait(others.size());
  const ProgramRun killed = grade(first, out_, {"-j", "1"}, [&](const RunningProgram& grades) {
    EXPECT_TRUE(grades.wait_until([&] { return fs::exists(out_ / "staff" / "other-order.json"); }));
    kill(-grades.process, SIGSTOP);
    std::vector<std::jthread> graders;
    for (std::size_t i = 0; i < others.size(); ++i)
      graders.emplace_back([&, i] {
        runs[i] = grade({others[i]}, out_, {}, [&](const RunningProgram& other) {
          EXPECT_TRUE(other.wait_until_it_says(kWaiting));
          all_wait.count_down();
        });
      });
    all_wait.wait();
    EXPECT_FALSE(fs::exists(out_ / "stubs"));
    kill(-grades.process, SIGKILL);
  });
  EXPECT_EQ(killed.code, -1);
  for (const ProgramRun& run : runs) {
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_EQ(lines_with(run.errors, kWaiting), 1) << run.errors;
    EXPECT_EQ(lines_with(run.errors, "\n"), 1) << run.errors;
  }
  const string gradebook = hair::bytes_of(out_ / "grades.csv");
  for (const char* row : {"\r\nother-order,20,", "\r\nprints-success,", "\r\nsegfault,", "\r\nstubs,0,"})
    EXPECT_NE(gradebook.find(row), string::npos) << row << " is not in " << gradebook;
  for (const char* row : {"perfect", "textbook"}) EXPECT_EQ(gradebook.find(row), string::npos) << gradebook;

  const ProgramRun resumed = grade(first, out_, {"--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.errors;
  EXPECT_NE(resumed.output.find("2 graded, 4 kept from before"), string::npos) << resumed.output;
  std::vector<string> everybody = first;
  everybody.insert(everybody.end(), others.begin(), others.end());
  const fs::path undisturbed = temporary_.path() / "undisturbed";
  ASSERT_EQ(grade(everybody, undisturbed).code, 0);
  expect_same(out_, undisturbed);
  const string costs = hair::bytes_of(out_ / "costs.html"), timing = hair::bytes_of(out_ / "timing.json");
  for (const string& name : everybody) {
    EXPECT_NE(costs.find("staff/" + name + ".html"), string::npos) << name;
    EXPECT_NE(timing.find("\"" + name + "\""), string::npos) << name;
  }
}

TEST_F(OneFolder, CanBeLeftWhileItIsWaitedFor) {
  fs::create_directory(out_);
  const Descriptor lock(open((out_ / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  ASSERT_EQ(flock(lock.get(), LOCK_EX), 0);
  const ProgramRun run = grade({"stubs"}, out_, {}, [&](const RunningProgram& waits) {
    EXPECT_TRUE(waits.wait_until_it_says(kWaiting));
    kill(-waits.process, SIGINT);
  });
  EXPECT_EQ(run.code, 130) << run.errors;
  EXPECT_EQ(run.errors, "hairgrade: " + out_.string() + kWaiting +
                            "hairgrade: interrupted while it waited; nothing was written\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(out_), {}), 1) << "the lock alone";
}

TEST_F(OneFolder, IsNotMixedWithOtherRules) {
  ASSERT_EQ(grade({"stubs"}, out_).code, 0);
  const std::map<string, string> before = files(out_);
  const ProgramRun run =
      grade({"other-order"}, out_, {"--secret", write("other", "another secret for this test")});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.errors.find("another secret"), string::npos) << run.errors;
  EXPECT_EQ(files(out_), before);
}

}  // namespace
}  // namespace grader

// STAFF ONLY. Four processes write to two hand-ins of one record, and each is killed at a random time, again
// and again: each result that was reported as done is there once, and results and log agree. A regrade that
// is killed leaves all results as they were, or has changed all.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "grader/course/input.h"
#include "grader/record/changes.h"
#include "grader/sandbox/processes/descriptor.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline record {
namespace {

constexpr int kProcesses = 4, kStudents = 6;
constexpr std::array<const char*, 2> kHandIns{"week 1", "week 2"};

std::string hand_in_of(std::int64_t number) {
  return kHandIns.at(static_cast<std::size_t>(number) % kHandIns.size());
}

// Makes a unique result: its number is in its points, and in its pictures.
Recorded numbered(std::int64_t number) {
  SubmissionResult result;
  result.name = "student-" + std::to_string(number / 2 % kStudents);  // each in both hand-ins
  result.origin = "hand-in /" + std::to_string(number);
  ExerciseResult exercise;
  exercise.id = "S1";
  exercise.points = static_cast<double>(number);
  exercise.staff_log = std::string(9000, 'x');  // is longer than a page
  exercise.pictures = {{"1 s", 0, 0, "picture " + std::to_string(number), "the reference's", ""}};
  result.exercises = {exercise};
  return {result, {}, {{"S1", {static_cast<double>(number)}}}};
}

// Writes results until it is killed, and reports each one that is done.
[[noreturn]] void write_on(const std::filesystem::path& folder, Journal journal, std::int64_t first,
                           int told) {
  try {
    std::array<Record, 2> records{Record(folder, kHandIns[0], journal), Record(folder, kHandIns[1], journal)};
    for (std::int64_t number = first;; ++number) {
      records.at(static_cast<std::size_t>(number % 2)).put(numbered(number));
      if (write(told, &number, sizeof number) != sizeof number) _exit(3);
    }
  } catch (const std::exception& error) {
    fprintf(stderr, "%s\n", error.what());
    _exit(2);
  }
}

std::int64_t number_of(const LogEntry& entry) {
  return std::llround(points_then(entry).at(0).points);
}

class Killed : public testing::TestWithParam<Journal> {
 protected:
  // Runs one round: four processes until each is killed. Returns the numbers that were reported as done.
  void write_and_kill(std::int64_t round) {
    Pipe told = make_pipe();
    std::array<pid_t, kProcesses> writers{};
    for (int i = 0; i < kProcesses; ++i)
      if (writers[i] = fork(); writers[i] == 0) {
        told.read_end.close();
        write_on(folder_.path(), GetParam(), (round * kProcesses + i) * 1'000'000, told.write_end.get());
      }
    told.write_end.close();
    // Otherwise they may be killed while they make the record.
    if (round % 2 == 0) take_one_told(told.read_end);
    std::shuffle(writers.begin(), writers.end(), random_);
    for (const pid_t writer : writers) {
      std::this_thread::sleep_for(std::chrono::microseconds(random_() % 60'000));
      kill(writer, SIGKILL);
      int status = 0;
      waitpid(writer, &status, 0);
      ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself, with " << WEXITSTATUS(status);
    }
    while (take_one_told(told.read_end)) {
    }
  }
  bool take_one_told(const Descriptor& from) {
    std::int64_t number = 0;
    const bool found = read(from.get(), &number, sizeof number) == sizeof number;
    if (found) done_.insert(number);
    return found;
  }

  void expect_all_once(std::size_t killed) {
    std::multiset<std::int64_t> logged;
    std::int64_t results = 0;
    for (const char* hand_in : kHandIns) {
      Record record(folder_.path(), hand_in, GetParam());
      for (const std::string& name : record.names()) {
        ++results;
        const std::vector<LogEntry> log = record.log(name);
        ASSERT_FALSE(log.empty());
        for (const LogEntry& entry : log) {
          logged.insert(number_of(entry));
          ASSERT_EQ(hand_in_of(number_of(entry)), hand_in);
        }
        const Recorded expected = numbered(number_of(log.back())), found = record.find(name).value();
        ASSERT_EQ(found.result, expected.result) << "a result and its log don't agree";
        ASSERT_EQ(found.costs, expected.costs);
      }
    }
    for (const std::int64_t number : done_) ASSERT_EQ(logged.count(number), 1U) << number;
    const std::set<std::int64_t> once(logged.begin(), logged.end());
    ASSERT_EQ(once.size(), logged.size()) << "one is there twice";
    ASSERT_LE(logged.size(), done_.size() + killed) << "one that was killed had begun one more at most";
    Database database(folder_.path() / kRecordFile, GetParam());
    ASSERT_EQ(database.text("PRAGMA integrity_check"), "ok");
    ASSERT_EQ(database.number("SELECT count(*) FROM pragma_foreign_key_check"), 0);
    ASSERT_EQ(database.number("SELECT count(*) FROM pictures"), results == 0 ? 0 : results + 1);
  }

  void rounds(int count) {
    for (int round = 0; round < count && !HasFatalFailure(); ++round) {
      write_and_kill(round);
      if (!HasFatalFailure()) expect_all_once(static_cast<std::size_t>(round + 1) * kProcesses);
    }
    EXPECT_GE(done_.size(), static_cast<std::size_t>(count) / 2);
    std::cout << done_.size() << " results were told as done, by " << count * kProcesses
              << " processes that were killed\n";
  }

  hair::TemporaryFolder folder_{"killed"};
  std::mt19937 random_{43};
  std::set<std::int64_t> done_;
};
INSTANTIATE_TEST_SUITE_P(WithEachJournal, Killed, testing::Values(Journal::best, Journal::rollback));

// Regrades everybody, again and again, with the same points for all.
[[noreturn]] void regrade_on(const std::filesystem::path& folder, Journal journal, std::int64_t first,
                             int told) {
  try {
    Record record(folder, kHandIns[0], journal), stage(folder, std::string(kHandIns[0]) + kStage, journal);
    for (std::int64_t points = first;; ++points) {
      stage.begin_stage("suite " + std::to_string(points));
      for (int student = 0; student < kStudents; ++student) {
        Recorded one = numbered(2 * student);
        one.result.exercises[0].points = static_cast<double>(points);
        stage.put(one);
      }
      record.take_stage();
      if (write(told, &points, sizeof points) != sizeof points) _exit(3);
    }
  } catch (const std::exception& error) {
    fprintf(stderr, "%s\n", error.what());
    _exit(2);
  }
}

TEST_P(Killed, InARegradeLeavesTheResultsBeforeOrHasAllNewOnes) {
  for (int student = 0; student < kStudents; ++student)
    Record(folder_.path(), kHandIns[0], GetParam()).put(numbered(2 * student));
  for (std::int64_t round = 1; round <= 20; ++round) {
    const Pipe told = make_pipe();
    const pid_t regrades = fork();
    if (regrades == 0) regrade_on(folder_.path(), GetParam(), round * 1'000'000, told.write_end.get());
    if (round % 2 == 0) take_one_told(told.read_end);
    std::this_thread::sleep_for(std::chrono::microseconds(random_() % 100'000));
    kill(regrades, SIGKILL);
    int status = 0;
    waitpid(regrades, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself, with " << WEXITSTATUS(status);
    Record record(folder_.path(), kHandIns[0], GetParam());
    const std::string suite = record.made_by();
    const double points = suite.empty() ? 0 : std::stod(suite.substr(6));
    ASSERT_GE(points, static_cast<double>(done_.empty() ? 0 : *done_.rbegin())) << "it was told as done";
    for (int student = 0; student < kStudents; ++student) {
      const Recorded was = numbered(2 * student), now = record.find(was.result.name).value();
      const double expected = suite.empty() ? was.result.exercises[0].points : points;
      ASSERT_EQ(now.result.exercises[0].points, expected) << was.result.name << " and " << suite;
    }
  }
  EXPECT_GE(done_.size(), 10U);
}

TEST_P(Killed, ShortlyLosesNothingAndHasNothingTwice) {
  rounds(5);
}

TEST_P(Killed, AHundredTimesLosesNothingAndHasNothingTwice) {
  rounds(100);
}

}  // namespace
}  // namespace grader::record

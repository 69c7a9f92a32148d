// STAFF ONLY. Tests the files in the folder of reports and their contents.
#include "grader/report/report.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "grader/course/input.h"
#include "grader/report/facts/picture_files.h"
#include "grader/report/facts/sample_results.h"
#include "hair/io/files/base64.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline report {
namespace {

using tests::says;

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

class Reports : public testing::Test {
 protected:
  static Files files_in(const fs::path& dir) {
    Files files;
    for (const auto& item : fs::recursive_directory_iterator(dir)) {
      if (!item.is_regular_file()) continue;
      files[fs::relative(item.path(), dir).string()] = hair::bytes_of(item.path());
    }
    return files;
  }
  static void write_all(const fs::path& dir, const std::vector<SubmissionResult>& results) {
    for (const SubmissionResult& result : results) write_submission_reports(dir, result);
    write_class_reports(dir, results);
  }

  hair::TemporaryFolder temporary_{"report"};
  fs::path dir_ = temporary_.path();
};

TEST_F(Reports, StandWhereTheyShould) {
  write_file(dir_ / "junit.xml", "of an earlier run");
  write_all(dir_, sample_class(2));
  std::vector<std::string> names;
  for (const auto& [name, bytes] : files_in(dir_))
    if (!name.starts_with("staff/pictures/")) names.push_back(name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"alice/report.html", "alice/results.json", "bob/report.html",
                                      "bob/results.json", "grades.csv", "index.html", "staff/alice.html",
                                      "staff/alice.json", "staff/bob.html", "staff/bob.json"}));
}

TEST_F(Reports, TheSameResultsGiveTheSameBytes) {
  std::vector<SubmissionResult> results = sample_class(20);
  results.push_back(submission_full_of(std::string("\0\xff\x1b[31m<\"", 9)));
  write_all(dir_ / "first", results);
  write_all(dir_ / "second", results);
  EXPECT_EQ(files_in(dir_ / "first"), files_in(dir_ / "second"));
}

// Counts a picture's bytes, as a file and as a part of a page, in all files below a folder.
std::size_t times_stored(const Files& files, const std::string& png) {
  std::size_t stored = 0;
  for (const auto& [name, bytes] : files) stored += times(bytes, png) + times(bytes, hair::base64(png));
  return stored;
}

// Makes a submission whose pictures all differ from one another; only the reference's are shared by all.
SubmissionResult submission_with_all_pictures(const std::string& name) {
  SubmissionResult result = sample_class(1).front();
  result.name = name;
  int i = 0;
  const auto picture = [&] {
    const std::string number = std::to_string(i++) + ".";
    return PictureResult{number + " s",
                         0.1,
                         0.2,
                         name + "\x89 student " + number,
                         "\x89 reference " + number,
                         name + "\x89 heat " + number};
  };
  for (ExerciseResult& exercise : result.exercises) exercise.pictures = {picture(), picture(), picture()};
  return result;
}

std::vector<PictureResult> pictures_of(const SubmissionResult& result) {
  std::vector<PictureResult> all;
  for (const ExerciseResult& exercise : result.exercises)
    all.insert(all.end(), exercise.pictures.begin(), exercise.pictures.end());
  return all;
}

TEST_F(Reports, StoreAPictureInTheStudentsReportAndOnceForStaff) {
  const std::vector<SubmissionResult> results = {submission_with_all_pictures("alice"),
                                                 submission_with_all_pictures("bob")};
  write_all(dir_, results);
  const Files files = files_in(dir_);
  for (const SubmissionResult& result : results)
    for (const PictureResult& picture : pictures_of(result)) {
      EXPECT_EQ(times_stored(files, picture.student), 2u);
      EXPECT_EQ(times_stored(files, picture.heat), 2u);
      EXPECT_EQ(times_stored(files, picture.reference), 3u);  // both reports, and once for staff
      EXPECT_EQ(times_stored(files_in(dir_ / "staff"), picture.reference), 1u);
      EXPECT_EQ(times_stored(files_in(dir_ / result.name), picture.reference), 1u);
    }
}

TEST_F(Reports, StudentsPagesLeadToNothingOfTheStaffs) {
  const SubmissionResult result = submission_with_all_pictures("alice");
  write_submission_reports(dir_, result);
  for (const auto& [name, bytes] : files_in(dir_ / "alice")) {
    EXPECT_FALSE(says(bytes, "staff")) << name;
    EXPECT_FALSE(says(bytes, "pictures/")) << name;
    for (const PictureResult& picture : pictures_of(result))
      EXPECT_FALSE(says(bytes, picture_name(picture.student))) << name;
  }
  const fs::perms staff = fs::status(dir_ / "staff").permissions();
  EXPECT_EQ(staff, fs::perms::owner_all);
}

TEST_F(Reports, PicturesThatNoPageShowsAreRemoved) {
  const SubmissionResult before = submission_with_all_pictures("alice"),
                         bob = submission_with_all_pictures("bob");
  SubmissionResult after = before;
  after.exercises[0].pictures[0].student = "another";
  write_submission_reports(dir_, before);
  write_submission_reports(dir_, bob);
  remove_unshown_pictures(dir_);
  const Files both = files_in(dir_);
  remove_unshown_pictures(dir_);
  EXPECT_EQ(files_in(dir_), both);

  write_file(dir_ / "staff/pictures/notes.txt", "not ours");
  write_submission_reports(dir_, after);
  Files expected = files_in(dir_);
  EXPECT_EQ(expected.erase("staff/pictures/" + picture_name(before.exercises[0].pictures[0].student)), 1u);
  remove_unshown_pictures(dir_);
  EXPECT_EQ(files_in(dir_), expected);
}

TEST_F(Reports, OfOneAreRemovedAlone) {
  write_all(dir_, sample_class(1));
  const Files alone = files_in(dir_);
  write_all(dir_, sample_class(2));
  remove_reports(dir_, "bob");
  remove_unshown_pictures(dir_);
  write_class_reports(dir_, sample_class(1));
  EXPECT_EQ(files_in(dir_), alone);
}

TEST_F(Reports, NamesThatLeadElsewhereAreRefused) {
  for (const char* name : {"", ".", "..", "../x", "a/b", "staff", ".hidden"}) {
    SubmissionResult result;
    result.name = name;
    EXPECT_THROW(write_submission_reports(dir_, result), std::invalid_argument) << name;
  }
  EXPECT_TRUE(fs::is_empty(dir_));
}

TEST_F(Reports, AFolderThatCanNotBeMadeIsNamed) {
  std::ofstream(dir_ / "grades") << "a file";
  try {
    write_class_reports(dir_ / "grades", sample_class(1));
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_TRUE(says(std::string(error.what()), "grades/grades.csv: can't be written (Not a directory)"))
        << error.what();
  }
}

TEST_F(Reports, AFailedWriteLeavesTheEarlierFileAndNothingElse) {
  write_file(dir_ / "x", "earlier");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  setrlimit(RLIMIT_FSIZE, &small);
  std::string said;
  try {
    write_file(dir_ / "x", std::string(5000, 'x'));
  } catch (const BadInput& error) {
    said = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_TRUE(says(said, "x: can't be written (File too large)"));
  EXPECT_EQ(files_in(dir_), (Files{{"x", "earlier"}}));
}

TEST(Table, IsAlignedAndAscii) {
  std::vector<SubmissionResult> results = sample_class(4);
  results[1].name =
      "b\xc3\xb6"
      "b\x1b[31m";
  results[2].isolation = Isolation::none;
  results[3].images = false;
  results[0].ended_by_the_clock = {"S1", "runs"};
  std::ostringstream out;
  print_table(out, results);
  for (const char c : out.str()) EXPECT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7f));
  EXPECT_EQ(out.str(), R"(submission            S1    S2     P1  total
of                    30    20     +5     50
alice                 30    20      5     55
b\xc3\xb6b\x1b[31m    15    10    2.5   27.5
carol                 30   10!  wrong     40
dave                stub    10   stub     10
mean of 4           18.8  12.5    1.9   33.1
! points from before or after a crash or a limit
NOT FINAL, ended by the clock: alice: S1, runs
GRADED WITHOUT A SANDBOX
GRADED WITHOUT PICTURES
)");
}

TEST(Table, ShowsDecisions) {
  std::ostringstream out;
  print_table(out, class_with_decisions());
  EXPECT_EQ(out.str(), R"(submission    S1    S2     P1  total
of            30    20     +5     50
alice         30    20    exc     50  (excuse P1)
bob          20*    10    2.5   32.5  (points S1.2, comment)
carol         30   16*  wrong     46  (conflict: points S2)
dave         exc   exc    exc    exc  (excuse)
mean of 2   26.7  15.3    1.2   39.2
* a person set points (hairgrade log)
)");
}

TEST(Table, FitsTenExercisesIn100Columns) {
  std::vector<SubmissionResult> results = class_of_ten_exercises(30);
  results[3].name = "a-student-with-a-name-that-never-ends_s0123456789";
  std::ostringstream out;
  print_table(out, results);
  std::istringstream lines(out.str());
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_TRUE(says(out.str(), "a-student-with-a-..."));
}

TEST(Table, NamesPeopleInTheirLettersAndEndsWithTheFolder) {
  const std::vector<SubmissionResult> results = sample_class(4);
  const NamesForPeople people{
      {"alice", "Müller, Jörg"}, {"bob", "李伟 with a long, long name"}, {"carol", "X\x1b[31m"}};
  std::ostringstream out;
  print_table(out, results, people);
  EXPECT_EQ(out.str(), R"(submission              S1    S2     P1  total  folder
of                      30    20     +5     50
Müller, Jörg            30    20      5     55  alice
李伟 with a long,...    15    10    2.5   27.5  bob
X\x1b[31m               30   10!  wrong     40  carol
dave                  stub    10   stub     10  dave
mean of 4             18.8  12.5    1.9   33.1
! points from before or after a crash or a limit
)");
}

}  // namespace
}  // namespace grader::report

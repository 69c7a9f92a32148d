// STAFF ONLY. Tests a course with several hand-ins, from outside: one record, a folder of pages for each, and
// the course's page above them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "grader/record/record.h"
#include "grader/tests/broken_links.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;

constexpr const char* kCourse = R"({"exercises": {"H6": {"role": "absent"}},
  "hand_in": {"zone": "Europe/Berlin", "late_per_cent_a_day": 50},
  "hand_ins": {"week 1": {"exercises": ["S1"], "due": "2025-03-04 23:59"},
               "week 2": {"exercises": ["S2"], "due": "2025-03-11 23:59"}}})";

class SeveralHandIns : public testing::Test {
 protected:
  string write(const string& name, const string& text) const {
    std::ofstream(temporary_.path() / name) << text;
    return (temporary_.path() / name).string();
  }
  ProgramRun grade(const string& name, std::vector<string> options) const {
    options.insert(options.begin(),
                   {"grade", sample(name), "--out", out_.string(), "--no-images", "--secret",
                    write("secret", "a secret for this test"), "--cache",
                    (temporary_.path() / "cache").string(), "--course", write("course.json", kCourse)});
    return run_hairgrade(options);
  }
  ProgramRun run(std::vector<string> words) const {
    words.insert(words.end(), {"--out", out_.string()});
    return run_hairgrade(words);
  }
  static void expect_refused(const ProgramRun& run, const string& because) {
    EXPECT_EQ(run.code, 2) << run.errors;
    EXPECT_NE(run.errors.find(because), string::npos) << run.errors;
    EXPECT_EQ(run.errors.find('\n') + 1, run.errors.size()) << run.errors;
  }
  string file(const string& path) const { return hair::bytes_of(out_ / path); }

  hair::TemporaryFolder temporary_{"several-hand-ins"};
  const fs::path out_ = temporary_.path() / "grades";
};

TEST_F(SeveralHandIns, AreGradedIntoOneRecordWithATotalOnTheCoursesPage) {
  expect_refused(grade("other-order", {}), "name one by --hand-in: \"week 1\", \"week 2\"");
  expect_refused(grade("other-order", {"--hand-in", "week 3"}),
                 "has no hand-in \"week 3\"; there are \"week 1\"");
  expect_refused(grade("other-order", {"--hand-in", "week 1", "--exercise", "S2"}), "it asks for S1");
  EXPECT_FALSE(fs::exists(out_));

  const string times =
      write("times.csv", "name,time\nother-order,2025-03-05T10:00:00+01:00\nnobody,2025-03-05 10:00\n");
  const ProgramRun first = grade("other-order", {"--hand-in", "week 1", "--times", times});
  ASSERT_EQ(first.code, 0) << first.errors;
  EXPECT_NE(first.errors.find("line 3: nobody has a time, and no hand-in here"), string::npos)
      << first.errors;
  const ProgramRun second = grade("other-order", {"--hand-in", "week 2"});
  ASSERT_EQ(second.code, 0) << second.errors;
  EXPECT_NE(second.errors.find("give their times by --times"), string::npos) << second.errors;
  EXPECT_EQ(file("week_1/grades.csv").substr(0, 41), "submission,total,of,sandbox,pictures,S1,S");
  EXPECT_NE(
      file("week_1/other-order/report.html").find("handed in 2025-03-05 10:00:00, due 2025-03-04 23:59"),
      string::npos);
  EXPECT_EQ(file("grades.csv"),
            "submission,total,of,week 1,week 1 of,week 2,week 2 of\r\nother-order,36,52,16,32,20,20\r\n");
  EXPECT_EQ(broken_links(out_), std::vector<string>());

  expect_refused(run({"set", "other-order", "S2", "5", "--why", "x"}),
                 "name one by --hand-in: \"week 1\", \"week 2\"");
  expect_refused(run({"log", "other-order", "--hand-in", "week 9"}), "there are \"week 1\", \"week 2\"");
  ASSERT_EQ(run({"set", "other-order", "S2", "5", "--why", "x", "--hand-in", "week 2"}).code, 0);
  EXPECT_NE(file("grades.csv").find("other-order,21,52,16,32,5,20"), string::npos) << file("grades.csv");

  // Times that come later need no new grading.
  const string intime = write("intime.csv", "name,time\nother-order,2025-03-04 23:59:59\n");
  const ProgramRun again = grade("other-order", {"--hand-in", "week 1", "--resume", "--times", intime});
  EXPECT_NE(again.output.find("0 graded, 1 kept"), string::npos) << again.output;
  EXPECT_NE(file("grades.csv").find("other-order,37,52,32,32,5,20"), string::npos) << file("grades.csv");

  ASSERT_EQ(run({"forget", "other-order"}).code, 0);
  EXPECT_NE(std::system(("grep -rqaF other-order '" + out_.string() + "'").c_str()), 0);
  EXPECT_NE(std::system(("find '" + out_.string() + "' | grep -q other-order").c_str()), 0);
}

TEST_F(SeveralHandIns, AreLookedAtOneByOneForSharedCode) {
  const auto similar = [&](std::vector<string> more) {
    more.insert(more.begin(), {"similar", sample("perfect"), sample("other-order"), "--course",
                               write("course.json", kCourse), "--least", "1"});
    return run(more);
  };
  const ProgramRun all = similar({}), second = similar({"--hand-in", "week 2"});
  EXPECT_NE(all.output.find("S1: 2 files"), string::npos) << all.output << all.errors;
  EXPECT_NE(all.output.find("S2: 2 files"), string::npos) << all.output;
  EXPECT_EQ(second.output.find("S1: "), string::npos) << second.output;
  EXPECT_NE(second.output.find("S2: 2 files"), string::npos) << second.output << second.errors;
  EXPECT_EQ(file("index.html").find("conj_grad.cpp"), string::npos);
  expect_refused(similar({"--hand-in", "week 3"}), "has no hand-in \"week 3\"; there are \"week 1\"");
}

}  // namespace
}  // namespace grader

// STAFF ONLY. Tests a course with several hand-ins, from outside: one record, a folder of pages for each, and
// the course's page above them.
#include "grader/record/record.h"
#include "grader/tests/broken_links.h"
#include "grader/tests/in_a_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

constexpr const char* kCourse = R"({"exercises": {"H6": {"role": "absent"}},
  "hand_in": {"zone": "Europe/Berlin", "late_per_cent_a_day": 50},
  "hand_ins": {"week 1": {"exercises": ["S1"], "due": "2025-03-04 23:59"},
               "week 2": {"exercises": ["S2"], "due": "2025-03-11 23:59"}}})";

class SeveralHandIns : public InAFolder {
 protected:
  SeveralHandIns() : InAFolder(nlohmann::json::parse(kCourse)) {}
  ProgramRun grade(const string& name, std::vector<string> options) const {
    options.insert(options.begin(), sample(name));
    return InAFolder::grade(options);
  }
  string file(const string& name) const { return read("grades/" + name); }

  const fs::path out_ = root_ / "grades";
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
  EXPECT_TRUE(says(first.errors, "line 3: nobody has a time, and no hand-in here"));
  const ProgramRun second = grade("other-order", {"--hand-in", "week 2"});
  ASSERT_EQ(second.code, 0) << second.errors;
  EXPECT_TRUE(says(second.errors, "give their times by --times"));
  EXPECT_EQ(file("week_1/grades.csv").substr(0, 41), "submission,total,of,sandbox,pictures,S1,S");
  EXPECT_TRUE(
      says(file("week_1/other-order/report.html"), "handed in 2025-03-05 10:00:00, due 2025-03-04 23:59"));
  EXPECT_EQ(file("grades.csv"),
            "submission,total,of,week 1,week 1 of,week 2,week 2 of\r\nother-order,36,52,16,32,20,20\r\n");
  EXPECT_EQ(broken_links(out_), std::vector<string>());

  expect_refused(run({"set", "other-order", "S2", "5", "--why", "x"}),
                 "name one by --hand-in: \"week 1\", \"week 2\"");
  expect_refused(run({"log", "other-order", "--hand-in", "week 9"}), "there are \"week 1\", \"week 2\"");
  ASSERT_EQ(run({"set", "other-order", "S2", "5", "--why", "x", "--hand-in", "week 2"}).code, 0);
  EXPECT_TRUE(says(file("grades.csv"), "other-order,21,52,16,32,5,20"));

  // Times that come later need no new grading.
  const string intime = write("intime.csv", "name,time\nother-order,2025-03-04 23:59:59\n");
  const ProgramRun again = grade("other-order", {"--hand-in", "week 1", "--resume", "--times", intime});
  EXPECT_TRUE(says(again.output, "0 graded, 1 kept"));
  EXPECT_TRUE(says(file("grades.csv"), "other-order,37,52,32,32,5,20"));

  ASSERT_EQ(run({"forget", "other-order"}).code, 0);
  EXPECT_NE(std::system(("grep -rqaF other-order '" + out_.string() + "'").c_str()), 0);
  EXPECT_NE(std::system(("find '" + out_.string() + "' | grep -q other-order").c_str()), 0);
}

TEST_F(SeveralHandIns, AreLookedAtOneByOneForSharedCode) {
  const auto similar = [&](std::vector<string> more) {
    more.insert(more.begin(), {"similar", sample("perfect"), sample("other-order"), "--course",
                               path("course.json"), "--least", "1"});
    return run(more);
  };
  const ProgramRun all = similar({}), second = similar({"--hand-in", "week 2"});
  EXPECT_TRUE(says(all.output, "S1: 2 files")) << all.errors;
  EXPECT_TRUE(says(all.output, "S2: 2 files"));
  EXPECT_FALSE(says(second.output, "S1: "));
  EXPECT_TRUE(says(second.output, "S2: 2 files")) << second.errors;
  EXPECT_FALSE(says(file("index.html"), "conj_grad.cpp"));
  expect_refused(similar({"--hand-in", "week 3"}), "has no hand-in \"week 3\"; there are \"week 1\"");
}

}  // namespace
}  // namespace grader

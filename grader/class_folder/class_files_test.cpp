// STAFF ONLY. Tests that the files of a folder of grades match its record, after any change.
#include "grader/class_folder/class_files.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/report/facts/sample_results.h"
#include "grader/report/facts/text.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline class_folder {
namespace {

namespace fs = std::filesystem;

class ClassFiles : public testing::Test {
 protected:
  static TimingByExercise cost(double seconds) {
    TimingByExercise all;
    for (const char* part : {"S1", "S2"}) all[part].suite_seconds = seconds;
    return all;
  }
  void write() { write_class_files(folder_, record_); }
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      if (entry.is_regular_file() && !entry.path().filename().string().starts_with(kRecordFile))
        all[fs::relative(entry.path(), folder_).string()] = hair::bytes_of(entry.path());
    return all;
  }
  nlohmann::json timing() const { return nlohmann::json::parse(files().at("timing.json")); }

  hair::TemporaryFolder temporary_{"class-files"};
  const fs::path folder_ = temporary_.path();
  Record record_{folder_};
};

TEST_F(ClassFiles, AreThoseOfTheRecordWhateverBecameOfThem) {
  for (const SubmissionResult& result : sample_class(7)) record_.put({result, {}, cost(2)});
  SubmissionResult studied = sample_class(1).front();
  studied.name = "studied";
  studied.studied = true;
  record_.put({studied, SubmissionStudy{}, cost(1)});
  write();
  const std::map<std::string, std::string> made = files();
  EXPECT_TRUE(made.contains("studied/study.html"));
  for (const auto& [name, bytes] : made) {
    write_file(folder_ / name, "{\"points\": 100}");
    write();
    EXPECT_TRUE(files() == made) << name << " was changed";
    fs::remove(folder_ / name);
    write();
    EXPECT_TRUE(files() == made) << name << " was removed";
  }
}

TEST_F(ClassFiles, AreTheSameBeforeAndAfterTheRecord) {
  SubmissionResult full = submission_full_of(std::string("\0\xff\x1b[31m<\"", 9));
  full.name = "full";
  record_.put({full});
  write_student_files(folder_, {full}, {});
  const std::map<std::string, std::string> made = files();
  write();
  for (const auto& [name, bytes] : made) EXPECT_TRUE(files().at(name) == bytes) << name;
}

TEST_F(ClassFiles, TellTheCostsOfEverybodyAndWhoseTheClockEnded) {
  std::vector<SubmissionResult> both = sample_class(2);
  both[1].ended_by_the_clock = {"S2", "runs"};
  record_.set_run(cost(4), {});
  record_.put({both[0], {}, cost(2)});
  write();
  EXPECT_FALSE(timing().contains("ended_by_the_clock"));
  EXPECT_FALSE(timing().contains("last_run"));
  record_.put({both[1], {}, cost(5)});
  record_.set_run(cost(4), LastRun{10, 1, 2});
  write();
  EXPECT_EQ(timing()["reference"]["S1"]["suite_seconds"], 4);
  EXPECT_EQ(timing()["submissions"]["alice"]["S2"]["suite_seconds"], 2);
  EXPECT_EQ(timing()["submissions"]["bob"]["S1"]["suite_seconds"], 5);
  EXPECT_EQ(timing()["last_run"]["submissions_per_minute"], 6);
  EXPECT_EQ(timing()["ended_by_the_clock"].dump(), R"({"bob":["S2","runs"]})");
  EXPECT_NE(files().at("costs.html").find("staff/bob.html"), std::string::npos);
}

TEST_F(ClassFiles, SayWhichFilesWereLeftOverAndThatARunWasKilled) {
  record_.put({sample_class(1).front()});
  record_.set_listed({{"c.zip/x.cpp", Accounted::As::left_over, "belongs to nobody", ""},
                      {"c.zip/old.cpp", Accounted::As::older, "a newer one counts", "alice"}});
  record_.set_run(cost(4), LastRun{.jobs = 1, .began = record_.now(), .asked = 2, .done = 1});
  write();
  const auto json = nlohmann::json::parse(files().at("left-over.json"));
  EXPECT_EQ(json["left_over"].dump(), R"([{"path":"c.zip/x.cpp","reason":"belongs to nobody","whose":""}])");
  EXPECT_EQ(json["older"][0]["whose"], "alice");
  EXPECT_EQ(json["notices"].dump(), R"(["c.zip/x.cpp: was not graded, since it belongs to nobody"])");
  const std::string page = files().at("index.html");
  EXPECT_NE(page.find("c.zip/x.cpp"), std::string::npos);
  EXPECT_NE(page.find("has not ended: 1 of 2"), std::string::npos);
}

// Week 1 uses the free day that week 2 would need.
TEST_F(ClassFiles, OfSeveralHandInsAreMadeWhereAnotherOneChangesThem) {
  HandInRules rules;
  rules.due = "2025-03-04 23:59";
  rules.late_per_cent_a_day = 100;
  rules.total_per_cent_at_most = 1000;
  rules.free_days_in_all = 1;
  Record first(folder_, "week 1"), second(folder_, "week 2");
  first.set_rules(rules);
  rules.due = "2025-03-11 23:59";
  second.set_rules(rules);
  const SubmissionResult alice = sample_class(1).front();
  const std::string reached = shown_points(points(alice)), most = shown_points(max_points(alice));
  second.put({alice}, {"2025-03-12 12:00:00"});
  write_class_files(folder_, second);
  const std::string head = "submission,total,of,week 1,week 1 of,week 2,week 2 of\r\n";
  EXPECT_EQ(files().at("grades.csv"),
            head + "alice," + reached + "," + most + ",,," + reached + "," + most + "\r\n");
  const std::map<std::string, std::string> before = files();
  first.put({alice}, {"2025-03-05 12:00:00"});
  write_class_files(folder_, first);
  EXPECT_NE(files().at("week_2/alice/report.html"), before.at("week_2/alice/report.html"));
  EXPECT_NE(files().at("week_2/alice/report.html").find("Late by 1 day"), std::string::npos);
  EXPECT_NE(files().at("grades.csv").find("," + reached + "," + most + ",0," + most), std::string::npos)
      << files().at("grades.csv");
  EXPECT_EQ(files().at("week_1/index.html").find("week_2"), std::string::npos);
  EXPECT_NE(files().at("index.html").find("week_1/staff/alice.html"), std::string::npos);
}

}  // namespace
}  // namespace grader::class_folder

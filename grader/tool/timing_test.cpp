// STAFF ONLY. timing.json keeps the costs of everybody who has a result, whichever run graded them.
#include "grader/tool/timing.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader {
namespace {

class TimingOfAFolder : public testing::Test {
 protected:
  static TimingByExercise cost(const std::vector<std::string>& parts, double seconds) {
    TimingByExercise all;
    for (const std::string& part : parts) {
      all[part].suite_seconds = seconds;
      all[part].worker_starts = 3;
    }
    return all;
  }
  static std::vector<SubmissionResult> results(const std::vector<std::string>& names) {
    std::vector<SubmissionResult> all(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) all[i].name = names[i];
    return all;
  }
  nlohmann::json file() const { return nlohmann::json::parse(std::ifstream(folder() / "timing.json")); }
  const std::filesystem::path& folder() const { return temporary_.path(); }

  hair::TemporaryFolder temporary_{"timing"};
};

TEST_F(TimingOfAFolder, IsWrittenWithEachSubmissionAndKeptByTheNextRun) {
  Timing killed(folder(), cost({"S1", "S2"}, 1), false);
  killed.add("alice", cost({"S1", "S2"}, 2));
  EXPECT_EQ(file()["submissions"]["alice"]["S1"]["suite_seconds"], 2);
  EXPECT_EQ(file()["submissions"]["alice"]["S1"]["worker_starts"], 3);
  Timing next(folder(), cost({"S1", "S2"}, 4), false);
  next.add("bob", cost({"S1"}, 5));
  next.finish(results({"alice", "bob"}), {10, 1, 2});
  EXPECT_EQ(file()["reference"]["S1"]["suite_seconds"], 4);
  EXPECT_EQ(file()["submissions"]["alice"]["S2"]["suite_seconds"], 2);
  EXPECT_EQ(file()["submissions"]["bob"].size(), 1U);
  EXPECT_EQ(file()["last_run"]["submissions_per_minute"], 6);
}

TEST_F(TimingOfAFolder, ListsWhatTheClockEnded) {
  Timing timing(folder(), cost({"S1", "S2"}, 1), false);
  std::vector<SubmissionResult> both = results({"alice", "bob"});
  timing.finish(both, {});
  EXPECT_FALSE(file().contains("ended_by_the_clock"));
  both[1].ended_by_the_clock = {"S2", "runs"};
  timing.finish(both, {});
  EXPECT_EQ(file()["ended_by_the_clock"].dump(), R"({"bob":["S2","runs"]})");
}

TEST_F(TimingOfAFolder, OfOneExerciseKeepsThoseOfTheOthers) {
  Timing all(folder(), cost({"S1", "S2"}, 1), false);
  all.add("alice", cost({"S1", "S2"}, 2));
  Timing one(folder(), cost({"S2"}, 3), true);
  one.add("alice", cost({"S2"}, 4));
  for (const nlohmann::json& parts : {file()["reference"], file()["submissions"]["alice"]})
    EXPECT_EQ(parts.size(), 2U) << parts;
  EXPECT_EQ(file()["submissions"]["alice"]["S2"]["suite_seconds"], 4);
}

TEST_F(TimingOfAFolder, LeavesOutWhoHasNoResultAnyMore) {
  Timing timing(folder(), cost({"S1"}, 1), false);
  timing.add("alice", cost({"S1"}, 2));
  timing.add("bob", cost({"S1"}, 2));
  timing.finish(results({"bob"}), {});
  EXPECT_FALSE(file()["submissions"].contains("alice"));
  const std::string page = hair::bytes_of(folder() / "costs.html");
  EXPECT_NE(page.find("staff/bob.html"), std::string::npos);
  EXPECT_EQ(page.find("alice"), std::string::npos);
}

TEST_F(TimingOfAFolder, BeginsAnewWhereTheFileIsDamagedAndSaysSo) {
  EXPECT_EQ(Timing(folder(), cost({"S1"}, 1), false).damage(), "");
  const std::string file_name = (folder() / "timing.json").string();
  for (const char* text : {R"({"submissions": [3, {"S1": null}], "reference": "x)",
                           R"({"submissions": [3, {"S1": null}], "reference": "x"})", ""}) {
    std::ofstream(file_name) << text;
    Timing again(folder(), cost({"S1"}, 1), false);
    EXPECT_TRUE(again.damage().starts_with(file_name + ": ")) << again.damage();
    EXPECT_EQ(again.damage().find('\n'), std::string::npos) << again.damage();
    again.add("bob", cost({"S1"}, 2));
    EXPECT_EQ(file()["submissions"]["bob"]["S1"]["suite_seconds"], 2);
    EXPECT_EQ(Timing(folder(), cost({"S1"}, 1), false).damage(), "");
  }
}

}  // namespace
}  // namespace grader

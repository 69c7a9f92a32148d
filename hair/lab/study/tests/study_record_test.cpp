// STAFF ONLY. The record of a study: failures by name, runs to resume from.
#include "hair/lab/study/study_record.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "studies.h"

namespace reference_tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class StudyRecord : public testing::Test {
 protected:
  fs::path keep(const hair::Study& study) const {
    hair::write_file(folder_ / "study.json", hair::record_text(hair::study_json(study)));
    return folder_ / "study.json";
  }
  std::string why_refused(const fs::path& file, hair::Study study) const {
    try {
      hair::read_runs(file, study);
    } catch (const hair::BadInput& error) {
      return error.what();
    }
    return "";
  }

  hair::TemporaryFolder temporary_{"hair-study"};
  fs::path folder_ = temporary_.path();
};

// The JSON as a reader sees it: NaN is null.
Json json_of(const hair::Study& study) {
  return Json::parse(hair::record_text(hair::study_json(study)));
}

// The record without values that differ between runs.
std::string timeless(const hair::Study& study) {
  Json json = json_of(study);
  json["reference"].erase("seconds");
  for (Json& method : json["methods"])
    for (Json& run : method["runs"]) {
      run.erase("time");
      run.erase("seconds");
    }
  return json.dump(1);
}

const std::vector<std::string> kMethods = {"forward-euler", "runge-kutta-4", "h4-filtered"};

TEST_F(StudyRecord, ARunThatBrokeStaysByNameInAllThatIsWritten) {
  const hair::Study study = studied(kHair, 0.02, {"forward-euler", "runge-kutta-4"}, 3e5).whole();
  const hair::MethodRun& first = sweep_of(study, "forward-euler").runs.at(0);
  ASSERT_EQ(first.ending, hair::RunEnding::broke) << shown(sweep_of(study, "forward-euler"));
  ASSERT_TRUE(first.trouble.starts_with("strand 0, step ")) << first.trouble;
  EXPECT_LT(first.counts.steps, first.steps_per_moment * hair::kMoments) << "it is not stopped at once";
  const Json run = json_of(study)["methods"][0]["runs"][0];
  EXPECT_EQ(run["ending"], "broke");
  EXPECT_EQ(run["trouble"], first.trouble);
  EXPECT_FALSE(run.contains("errors"));
  EXPECT_NE(hair::csv_of(hair::run_rows(study)).find(first.trouble), std::string::npos);
  EXPECT_NE(hair::to_html(hair::study_page(study)).find(first.trouble), std::string::npos);
}

TEST_F(StudyRecord, ErrorsBelowTheFloorAreNoNumbers) {
  const hair::Study study = studied(kPendulum, 0.1, {"runge-kutta-4"}, 1e7).whole();
  const Json json = json_of(study);
  const Json& errors = json["methods"][0]["runs"].back()["errors"];
  EXPECT_TRUE(errors["final_largest"].is_null()) << errors.dump();
  for (const Json& run : json["methods"][0]["runs"])
    for (const auto& [norm, error] : run["errors"].items())
      EXPECT_TRUE(error.is_null() || error.get<double>() >= json["floors"][norm].get<double>())
          << norm << ": " << error;
}

TEST_F(StudyRecord, ResumedItIsTheSameAsOneThatWasNeverInterrupted) {
  const Studied all = studied(kSoftHair, 0.1, kMethods, 3e5);
  const hair::Study whole = all.whole();
  for (const int runs : {1, 7}) {
    std::atomic<bool> interrupted = false;
    int started = 0;
    hair::StudySettings settings = all.settings;
    settings.progress = [&](const std::string&) { interrupted = started++ == runs; };
    hair::Study part = all.empty();
    EXPECT_FALSE(hair::finish_study(all.problem, all.motion, settings, part, interrupted));
    const fs::path file = keep(part);
    EXPECT_EQ(json_of(part)["finished"], false);

    hair::Study resumed = all.empty();
    hair::read_runs(file, resumed);
    int kept = 0;
    for (const hair::Sweep& sweep : resumed.sweeps) kept += static_cast<int>(sweep.runs.size());
    EXPECT_EQ(kept, runs);
    started = 0;
    settings.progress = [&](const std::string&) { ++started; };
    EXPECT_TRUE(hair::finish_study(all.problem, all.motion, settings, resumed, false));
    EXPECT_EQ(timeless(resumed), timeless(whole));
    int in_all = 0;
    for (const hair::Sweep& sweep : whole.sweeps) in_all += static_cast<int>(sweep.runs.size());
    EXPECT_EQ(started, in_all - runs) << "runs that were there are run again";
  }
}

// The record keeps of errors below the floors only that they are below: later choices may depend on no more.
TEST_F(StudyRecord, AResumedStudyKnowsNoMoreOfErrorsBelowTheFloorsThanOneThatWasNot) {
  Studied all = studied(kPendulum, 0.1, {"midpoint", "runge-kutta-4"}, 1e6);
  all.motion.agreement = 1e-5;
  const hair::Study whole = all.whole();
  hair::Study resumed = all.empty();
  hair::read_runs(keep(whole), resumed);
  int below = 0;
  for (std::size_t i = 0; i < whole.sweeps.size(); ++i) {
    ASSERT_EQ(resumed.sweeps[i].runs.size(), whole.sweeps[i].runs.size());
    for (std::size_t k = 0; k < whole.sweeps[i].runs.size(); ++k)
      for (int n = 0; n < hair::kNorms; ++n) {
        const hair::Norm norm = static_cast<hair::Norm>(n);
        const double error = whole.sweeps[i].runs[k].errors[norm];
        EXPECT_EQ(resumed.sweeps[i].runs[k].errors[norm], error) << hair::name_of(norm).id;
        if (error == 0) ++below;
      }
  }
  EXPECT_GT(below, 0);
}

// A position that is known only at the end does not show whether smaller steps make a difference.
TEST_F(StudyRecord, ASweepDoesNotStallWhereNothingIsKnownOfItsErrors) {
  const Studied all = studied(kPendulum, 0.1, {"midpoint"}, 1e6);
  hair::Study study = all.empty();
  hair::Sweep& sweep = study.sweeps[0];
  hair::MethodRun run;
  run.errors[hair::Norm::final_largest] = 1;
  for (const double error : {0.0, 1e-3}) {
    run.errors[hair::Norm::trajectory] = error;
    run.steps_per_moment = 1;
    sweep.runs.assign(5, run);
    EXPECT_EQ(hair::next_steps(sweep, study.floors, 1, 1e6, 3).has_value(), error == 0);
  }
}

TEST_F(StudyRecord, OfSomethingElseIsRefusedAndSaysWhatDiffers) {
  const Studied all = studied(kSoftHair, 0.1, kMethods, 1e4);
  const fs::path file = keep(all.whole());
  EXPECT_EQ(why_refused(file, all.empty()), "");

  hair::Study other = all.empty();
  other.content = "0";
  EXPECT_NE(why_refused(file, other).find("its \"content\" is "), std::string::npos)
      << why_refused(file, other);
  other = all.empty();
  other.machine.processor = "abacus";
  EXPECT_NE(why_refused(file, other).find("\"machine\""), std::string::npos);
  other = all.empty();
  other.sweeps.pop_back();
  EXPECT_NE(why_refused(file, other).find("\"methods\""), std::string::npos);
  other = all.empty();
  other.most_work *= 2;
  EXPECT_NE(why_refused(file, other).find("\"most_work\""), std::string::npos);

  other = all.empty();
  other.program_digest = "of another";
  EXPECT_NE(why_refused(file, other).find("the program is another than the one that began this study; "),
            std::string::npos);

  Json broken = json_of(all.whole());
  const Json whole = broken;
  broken["methods"] = {1};
  hair::write_file(file, broken.dump());
  EXPECT_NE(why_refused(file, all.empty()).find("its \"methods\" is [1], not "), std::string::npos);
  broken = whole;
  broken["methods"][0].erase("runs");
  hair::write_file(file, broken.dump());
  EXPECT_NE(why_refused(file, all.empty()).find("methods[0]: \"runs\" is missing"), std::string::npos)
      << why_refused(file, all.empty());
  broken = whole;
  broken["format"] = 2;
  hair::write_file(file, broken.dump());
  EXPECT_NE(why_refused(file, all.empty()).find("\"format\""), std::string::npos);
  hair::write_file(file, "{}");
  EXPECT_NE(why_refused(file, all.empty()).find("is not from hairlab study"), std::string::npos);
  EXPECT_NE(why_refused(folder_ / "none.json", all.empty()), "");
}

TEST_F(StudyRecord, OfRunsThatNoStudyWritesIsRefused) {
  const Studied all = studied(kSoftHair, 0.1, {"runge-kutta-4"}, 1e5);
  const Json whole = json_of(all.whole());
  const Json runs = whole["methods"][0]["runs"];
  ASSERT_GE(runs.size(), 3u);
  const auto expect_refused = [&](const Json& spoiled, const std::string& part) {
    Json record = whole;
    record["methods"][0]["runs"] = spoiled;
    hair::write_file(folder_ / "study.json", record.dump());
    const std::string why = why_refused(folder_ / "study.json", all.empty());
    EXPECT_NE(why.find(part), std::string::npos) << "says \"" << why << "\", not \"" << part << "\"";
  };
  Json spoiled = runs;
  spoiled[1]["seconds"] = Json::array();
  expect_refused(spoiled, "methods[0].runs[1].seconds: is empty");
  spoiled[1]["seconds"] = {1e-3, -1e-3};
  expect_refused(spoiled, "methods[0].runs[1].seconds[1]: -0.001 is not right");
  spoiled = runs;
  for (const Json& run : runs) spoiled.push_back(run);
  const std::string behind = std::to_string(runs.size());
  expect_refused(spoiled, "methods[0].runs[" + behind +
                              "].steps_per_moment: 2 is not right; it is twice that of the run before, ");
  spoiled = runs;
  spoiled.erase(1);
  expect_refused(spoiled, "methods[0].runs[1].steps_per_moment: ");
  spoiled = runs;
  spoiled.back().erase("errors");
  expect_refused(spoiled, "methods[0].runs[" + std::to_string(runs.size() - 1) + "]: \"errors\" is missing");
}

}  // namespace
}  // namespace reference_tests

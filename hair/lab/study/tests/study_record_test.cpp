// STAFF ONLY. A study's record names failures, and quotes no error below the floors.
#include "hair/lab/study/study_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "studies.h"

namespace reference_tests {
namespace {

using Json = nlohmann::json;

// The JSON as a reader sees it: NaN is null.
Json json_of(const hair::Study& study) {
  return Json::parse(hair::record_text(hair::study_json(study)));
}

TEST(StudyRecord, ARunThatBrokeStaysByNameInAllThatIsWritten) {
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

TEST(StudyRecord, ErrorsBelowTheFloorAreNoNumbers) {
  const hair::Study study = studied(kPendulum, 0.1, {"runge-kutta-4"}, 1e7).whole();
  const Json json = json_of(study);
  const Json& errors = json["methods"][0]["runs"].back()["errors"];
  EXPECT_TRUE(errors["final_largest"].is_null()) << errors.dump();
  for (const Json& run : json["methods"][0]["runs"])
    for (const auto& [norm, error] : run["errors"].items())
      EXPECT_TRUE(error.is_null() || error.get<double>() >= json["floors"][norm].get<double>())
          << norm << ": " << error;
}

// A position that is known only at the end does not show whether smaller steps make a difference.
TEST(StudyRecord, ASweepDoesNotStallWhereNothingIsKnownOfItsErrors) {
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

}  // namespace
}  // namespace reference_tests

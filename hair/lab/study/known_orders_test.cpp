// STAFF ONLY. A study's errors fall as theory says, with the reference. Its record names failures, and quotes
// no error below the floors.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hair/lab/study/observed_order.h"
#include "hair/lab/study/study_record.h"
#include "hair/lab/study/test_studies.h"
#include "hair/lab/study/written_down.h"

namespace reference_tests {
namespace {

using hair::Norm;

using Json = nlohmann::json;

// An error c h^p (1 + d h + ...) shows the order p + d h / (2 ln 2) from h to h/2: each halving of the
// step halves the deviation, so the last order is off by as much as it differs from the previous one. The
// bound adds half as much for the terms that follow, and 0.02 for the reference's own error, which is
// below 1/100 of these. At a single moment c may pass through 0; over all of them it does not.
void expect_order(const hair::Study& study, const std::string& id, int order) {
  const Norm norm = Norm::trajectory;
  const hair::Sweep& sweep = sweep_of(study, id);
  std::vector<double> errors;
  for (const hair::MethodRun& run : sweep.runs)
    if (run.ending == hair::RunEnding::finished && run.errors[norm] > 100 * study.floors[norm])
      errors.push_back(run.errors[norm]);
  const std::size_t n = errors.size();
  ASSERT_GE(n, 3u) << shown(sweep);
  const double last = std::log2(errors[n - 2] / errors[n - 1]),
               before = std::log2(errors[n - 3] / errors[n - 2]);
  EXPECT_LE(std::abs(last - before), 0.25) << "not asymptotic\n" << shown(sweep);
  EXPECT_LE(std::abs(last - order), 1.5 * std::abs(last - before) + 0.02)
      << "orders " << before << ", " << last << "\n"
      << shown(sweep);
  // The study finds the same order.
  const hair::ObservedOrder seen = hair::observed_order(sweep, norm, study.floors[norm]);
  ASSERT_TRUE(seen.order) << shown(sweep);
  EXPECT_NEAR(*seen.order, order, 0.25) << shown(sweep);  // the halvings that it takes agree to within that
  EXPECT_EQ(hair::verdict(sweep, seen), "as theory has it") << shown(sweep);
}

struct KnownOrder {
  std::string id;
  int order;
};

void expect_orders(const char* scene, double duration, const std::vector<KnownOrder>& all, double most_work) {
  std::vector<std::string> ids;
  for (const KnownOrder& one : all) ids.push_back(one.id);
  const hair::Study study = studied(scene, duration, ids, most_work).study;
  for (const auto& [id, order] : all) expect_order(study, id, order);
}

// RK4 is not among them: it is at the floor before its order can be seen.
TEST(KnownOrders, OfSoftHair) {
  expect_orders(
      kSoftHair, 0.1,
      {{"forward-euler", 1}, {"symplectic-euler", 1}, {"midpoint", 2}, {"h4-filtered", 1}, {"h4-dropped", 1}},
      2e6);
}

TEST(KnownOrders, OfAPendulum) {
  expect_orders(kPendulum, 0.4,
                {{"forward-euler", 1},
                 {"symplectic-euler", 1},
                 {"midpoint", 2},
                 {"runge-kutta-4", 4},
                 {"h4-filtered", 1}},
                5e5);
}

// The program of the staff arrives where the exercises do: add_written_down leaves out other runs.
TEST(WrittenDown, HasTheStudysErrors) {
  const std::vector<std::string> ids = {"symplectic-euler", "runge-kutta-4", "h4-filtered", "h4-dropped",
                                        "h6"};
  std::vector<std::string> all = ids;
  all.insert(all.end(), {"midpoint", "h4-filtered-plain", "h4-filtered-exact"});
  auto [problem, study] = studied(kSoftHair, 0.02, all, 1e5);
  hair::add_written_down(problem, study, false);
  EXPECT_EQ(study.sweeps.size(), all.size() + ids.size());
  for (const std::string& id : ids)
    EXPECT_EQ(sweep_of(study, id + "-written").runs.size(), sweep_of(study, id).runs.size()) << id;
}

// The JSON as a reader sees it: NaN is null.
Json json_of(const hair::Study& study) {
  return Json::parse(hair::record_text(hair::study_json(study)));
}

TEST(StudyRecord, ARunThatBrokeStaysByNameInAllThatIsWritten) {
  const hair::Study study = studied(kHair, 0.02, {"forward-euler", "runge-kutta-4"}, 3e5).study;
  const hair::MethodRun& first = sweep_of(study, "forward-euler").runs.at(0);
  ASSERT_EQ(first.ending, hair::RunEnding::broke) << shown(sweep_of(study, "forward-euler"));
  ASSERT_TRUE(first.trouble.starts_with("strand 0, step ")) << first.trouble;
  EXPECT_LT(first.counts.steps, first.steps_per_moment * hair::kMoments) << "it is not stopped at once";
  const Json run = json_of(study)["methods"][0]["runs"][0];
  EXPECT_EQ(run["ending"], "broke");
  EXPECT_EQ(run["trouble"], first.trouble);
  EXPECT_FALSE(run.contains("errors"));
  EXPECT_TRUE(says(hair::csv_of(hair::run_rows(study)), first.trouble));
  EXPECT_TRUE(says(hair::to_html(hair::study_page(study)), first.trouble));
}

// Once its errors are below the reference's accuracy, a method has no finer steps, and none of these errors
// is quoted.
TEST(StudyRecord, ASweepEndsAtTheFloorAndErrorsBelowItAreNoNumbers) {
  const hair::Study study = studied(kPendulum, 0.1, {"runge-kutta-4"}, 1e7).study;
  const hair::Sweep& sweep = study.sweeps[0];
  EXPECT_EQ(sweep.end, hair::SweepEnd::floor) << shown(sweep);
  const Norm norm = Norm::trajectory;
  EXPECT_LT(sweep.runs.back().errors[norm], study.floors[norm]);
  EXPECT_GE(sweep.runs[sweep.runs.size() - 2].errors[norm], study.floors[norm]) << shown(sweep);
  const Json json = json_of(study), &runs = json["methods"][0]["runs"];
  EXPECT_TRUE(runs.back()["errors"]["final_largest"].is_null()) << runs.back();
  for (const Json& run : runs)
    for (const auto& [name, error] : run["errors"].items())
      EXPECT_TRUE(error.is_null() || error.get<double>() >= json["floors"][name].get<double>())
          << name << ": " << error;
}

// A position that is known only at the end does not show whether smaller steps make a difference.
TEST(StudyRecord, ASweepDoesNotStallWhereNothingIsKnownOfItsErrors) {
  hair::Errors floors;
  floors[hair::Norm::final_largest] = floors[hair::Norm::trajectory] = 1e-6;
  hair::Sweep sweep;
  hair::MethodRun run;
  run.errors[hair::Norm::final_largest] = 1;
  for (const double error : {0.0, 1e-3}) {
    run.errors[hair::Norm::trajectory] = error;
    run.steps_per_moment = 1;
    sweep.runs.assign(5, run);
    EXPECT_EQ(hair::next_steps(sweep, floors, 1, 1e6, 3).has_value(), error == 0);
  }
}

}  // namespace
}  // namespace reference_tests

// STAFF ONLY. An exercise that throws breaks its runs and no others: a study keeps them, by name.
#include <gtest/gtest.h>

#include <stdexcept>

#include "hair/lab/study/study_figures.h"
#include "hair/lab/study/study_record.h"
#include "particles/explicit_integrators.h"
#include "studies.h"

namespace particles {

// Correct until it throws, which is after 2 ms of a fall, before the first of the study's moments.
void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  dynamics.acceleration(x, v, scratch.col(0));
  x += h * v;
  v += h * scratch.col(0);
  if (v.lpNorm<Eigen::Infinity>() > 0.02) throw std::invalid_argument("as checks of arguments do");
}

void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  dynamics.acceleration(x, v, scratch.col(0));
  v += h * scratch.col(0);
  x += h * v;
}

void midpoint(Dynamics&, double, Output, Output, Scratch) {
  throw std::bad_alloc();
}

void runge_kutta_4(Dynamics&, double, Output, Output, Scratch) {}

}  // namespace particles

namespace reference_tests {
namespace {

class ThrowingMethod : public testing::Test {
 protected:
  const hair::Study study_ =
      studied(kPendulum, 0.1, {"forward-euler", "symplectic-euler", "midpoint"}, 1e5).whole();
};

TEST_F(ThrowingMethod, BreaksItsRunsByNameAndNoOthers) {
  for (const char* id : {"forward-euler", "midpoint"}) {
    const hair::Sweep& sweep = sweep_of(study_, id);
    ASSERT_GE(sweep.runs.size(), 3u) << shown(sweep);
    EXPECT_EQ(sweep.end, hair::SweepEnd::budget) << shown(sweep);
    for (const hair::MethodRun& run : sweep.runs) EXPECT_EQ(run.ending, hair::RunEnding::broke);
  }
  const hair::MethodRun& last = sweep_of(study_, "forward-euler").runs.back();
  EXPECT_NE(last.trouble.find("threw as checks of arguments do"), std::string::npos) << last.trouble;
  EXPECT_TRUE(sweep_of(study_, "midpoint").runs[0].trouble.starts_with("step 1: threw "));
  for (const hair::MethodRun& run : sweep_of(study_, "symplectic-euler").runs)
    EXPECT_EQ(run.ending, hair::RunEnding::finished) << run.trouble;
  EXPECT_NE(hair::to_html(hair::study_page(study_)).find(last.trouble), std::string::npos);
}

// Forward Euler evaluates forces once a step: a whole run as often as it has steps, wherever it broke.
TEST_F(ThrowingMethod, CountsTheStepsBeforeItsFirstMoment) {
  const hair::Sweep& sweep = sweep_of(study_, "forward-euler");
  const hair::MethodRun& last = sweep.runs.back();
  EXPECT_GT(last.counts.steps, 1);
  EXPECT_LT(last.counts.steps, last.steps_per_moment);
  const hair::Figure figure = hair::error_figure(study_, hair::Norm::final_largest, hair::Against::work);
  ASSERT_EQ(figure.series[0].points.size(), sweep.runs.size());
  for (std::size_t k = 0; k < sweep.runs.size(); ++k) {
    EXPECT_EQ(sweep.runs[k].counts.evaluations, sweep.runs[k].counts.steps);
    EXPECT_DOUBLE_EQ(figure.series[0].points[k].x, sweep.runs[k].steps_per_moment * hair::kMoments);
  }
}

}  // namespace
}  // namespace reference_tests

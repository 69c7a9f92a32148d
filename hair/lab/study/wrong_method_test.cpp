// STAFF ONLY. A study exposes methods that are wrong, in words and in its orders. It names one that throws,
// and one that is not written.
#include <gtest/gtest.h>

#include <stdexcept>

#include "hair/lab/study/observed_order.h"
#include "hair/lab/study/study_record.h"
#include "hair/lab/study/test_studies.h"
#include "particles/explicit_integrators.h"

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

// Moves particles by the velocity of the start: of order 1.
void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  scratch.col(1) = x + h / 2 * v;
  scratch.col(2) = v;
  dynamics.acceleration(scratch.col(1), scratch.col(2), scratch.col(0));
  x += h * v;
  v += h * scratch.col(0);
}

// A symplectic Euler that is 1 % off in everything that pulls: it goes to another motion.
void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  dynamics.acceleration(x, v, scratch.col(0));
  v += 1.01 * h * scratch.col(0);
  x += h * v;
}

}  // namespace particles

namespace reference_tests {
namespace {

using hair::Norm;

TEST(WrongMethod, IsExposed) {
  const hair::Study study =
      studied(kPendulum, 0.1, {"forward-euler", "symplectic-euler", "midpoint", "runge-kutta-4"}, 2e6).study;
  const auto seen = [&](const char* id) {
    return hair::observed_order(sweep_of(study, id), Norm::trajectory, study.floors[Norm::trajectory]);
  };
  const auto said = [&](const char* id) { return hair::verdict(sweep_of(study, id), seen(id)); };
  EXPECT_EQ(said("symplectic-euler"), "as theory has it");

  // It has order 1 instead of 2.
  ASSERT_TRUE(seen("midpoint").order) << shown(sweep_of(study, "midpoint"));
  EXPECT_NEAR(*seen("midpoint").order, 1, 0.25) << shown(sweep_of(study, "midpoint"));
  EXPECT_EQ(said("midpoint"), "less than theory says");

  // RK4 converges to another motion: 1 % of gravity's effect in a tenth of a second, 0.01 * 9.81 * 0.1^2 / 2
  // = 5e-4 m, and at least a tenth of that because springs hold.
  const hair::ObservedOrder off = seen("runge-kutta-4");
  ASSERT_TRUE(off.stays_at) << shown(sweep_of(study, "runge-kutta-4"));
  EXPECT_GT(*off.stays_at, 5e-5);
  EXPECT_LT(*off.stays_at, 5e-4);
  EXPECT_EQ(sweep_of(study, "runge-kutta-4").end, hair::SweepEnd::stalls)
      << shown(sweep_of(study, "runge-kutta-4"));

  // Forward Euler evaluates forces once a step: a whole run as often as it has steps, wherever it broke.
  const hair::Sweep& sweep = sweep_of(study, "forward-euler");
  EXPECT_EQ(sweep.end, hair::SweepEnd::budget) << shown(sweep);
  const hair::Figure figure = hair::error_figure(study, hair::Norm::final_largest, hair::Against::work);
  ASSERT_EQ(figure.series[0].points.size(), sweep.runs.size());
  for (std::size_t k = 0; k < sweep.runs.size(); ++k) {
    const hair::MethodRun& run = sweep.runs[k];
    EXPECT_EQ(run.ending, hair::RunEnding::broke);
    EXPECT_TRUE(says(run.trouble, "threw as checks of arguments do"));
    EXPECT_EQ(run.counts.evaluations, run.counts.steps);
    EXPECT_DOUBLE_EQ(figure.series[0].points[k].x, run.steps_per_moment * hair::kMoments);
  }

  EXPECT_GT(sweep.runs.back().counts.steps, 1);
  EXPECT_LT(sweep.runs.back().counts.steps, sweep.runs.back().steps_per_moment);

  const std::string html = hair::to_html(hair::study_page(study));
  EXPECT_TRUE(says(html, sweep.runs.back().trouble));
  EXPECT_TRUE(says(html, "less than theory says"));
  EXPECT_TRUE(says(html, "m off, however small the step"));
}

// H6 is a stub in this program.
TEST(LeftOut, AMethodThatIsNotWrittenIsNamedAndTheOthersRun) {
  const hair::Study study = studied(kSoftHair, 0.05, {"h4-filtered", "h6"}, 1e5).study;
  EXPECT_GE(sweep_of(study, "h4-filtered").runs.size(), 3u);
  const hair::Sweep& left_out = sweep_of(study, "h6");
  EXPECT_TRUE(left_out.runs.empty());
  EXPECT_EQ(left_out.end, hair::SweepEnd::not_written);
  EXPECT_TRUE(left_out.left_out.starts_with("H6 ")) << left_out.left_out;
  EXPECT_TRUE(says(hair::to_html(hair::study_page(study)), "H6 is left out: H6 "));
}

}  // namespace
}  // namespace reference_tests

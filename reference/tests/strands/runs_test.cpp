// STAFF ONLY. The end-to-end runs with the reference.

#include "hair/runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

namespace reference_tests {
namespace {

TEST(Runs, EachEndsSoundWithItsFrames) {
  for (const hair::Run& run : hair::runs()) {
    const hair::RunResult result = hair::do_run(run.name);
    EXPECT_EQ(result.trouble, "") << run.name;
    ASSERT_GE(result.frames.size(), 10U) << run.name;
    const int particles = std::accumulate(run.strands.begin(), run.strands.end(), 0);
    double last = -1;
    for (const hair::Frame& frame : result.frames) {
      EXPECT_EQ(frame.state.x.size(), 3 * particles) << run.name;
      EXPECT_EQ(frame.state.v.size(), 3 * particles) << run.name;
      EXPECT_TRUE(frame.state.x.allFinite() && frame.state.v.allFinite()) << run.name;
      EXPECT_TRUE(std::isfinite(frame.stretch) && std::isfinite(frame.energy)) << run.name;
      EXPECT_GT(frame.time, last) << run.name;
      last = frame.time;
    }
    // Something moves: by a tenth of a millimetre at least.
    EXPECT_GT((result.frames.back().state.x - result.frames.front().state.x).norm(), 1e-4) << run.name;
  }
}

TEST(Runs, TwiceTheSameBits) {
  for (const hair::Run& run : hair::runs()) {
    const hair::RunResult one = hair::do_run(run.name), two = hair::do_run(run.name);
    for (std::size_t k = 0; k < one.frames.size(); ++k)
      EXPECT_EQ(one.frames[k].state.x, two.frames[k].state.x);
  }
}

TEST(Runs, TogetherNeedAllExercises) {
  std::set<std::string> all;
  for (const hair::Run& run : hair::runs()) all.insert(run.exercises.begin(), run.exercises.end());
  EXPECT_EQ(all, (std::set<std::string>{"S1", "P1", "P2", "H1", "H2", "H3", "H4", "H5", "H6"}));
}

TEST(Runs, StretchIsWhatTheMethodPromises) {
  for (const hair::Frame& frame : hair::do_run("strand-swing").frames) EXPECT_LE(frame.stretch, 1e-10);
  for (const hair::Frame& frame : hair::do_run("bead-on-wire").frames) EXPECT_LE(frame.stretch, 1e-3);
}

TEST(Runs, AnUnknownNameIsRefused) {
  EXPECT_THROW(hair::do_run("no-such-run"), std::invalid_argument);
}

}  // namespace
}  // namespace reference_tests

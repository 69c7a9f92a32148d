// STAFF ONLY. Threads over strands: no result of a simulation depends on their number.
#include "hair/simulation/strand_threads.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "hair/simulation/simulation.h"
#include "hair/simulation/test_hairs.h"

namespace reference_tests {
namespace {

using hair::StrandThreads;

TEST(StrandThreadsTest, DoEachTaskOnceAndEachThreadOneAtATime) {
  for (int count : {1, 2, 5}) {
    StrandThreads threads(count);
    EXPECT_EQ(threads.count(), count);
    for (int tasks : {0, 1, 3, 1000}) {
      std::vector<std::atomic<int>> done(tasks), busy(count);
      threads.run(tasks, [&](int thread, int i) {
        EXPECT_EQ(busy[thread]++, 0);
        ++done[i];
        --busy[thread];
      });
      for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
    }
  }
}

TEST(StrandThreadsTest, PassOnTheFirstExceptionAndGoOnAfterwards) {
  StrandThreads threads(3);
  for (int round = 0; round < 20; ++round) {
    try {
      threads.run(50, [](int, int i) {
        if (i == 7) throw std::runtime_error("seven");
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "seven");
    }
    std::atomic<int> done = 0;
    threads.run(50, [&](int, int) { ++done; });
    EXPECT_EQ(done, 50);
  }
}

TEST(StrandThreadsTest, DoNotChangeTheResult) {
  for (const Method method :
       {Method::symplectic_euler, Method::implicit_euler, Method::predictor_corrector}) {
    Description description;
    for (int i = 0; i < 9; ++i)
      description.strands.push_back(straight_hair(3 + 4 * i, 0.03 + 0.04 * i, Vector3d(0.6, 0, -0.8)));
    description.method = method;
    description.step = method == Method::symplectic_euler ? 1e-6 : 1.0 / 240;
    Simulation one(description);
    one.advance(30);
    for (int jobs : {2, 4}) {
      description.jobs = jobs;
      Simulation several(description);
      several.advance(30);
      for (int i = 0; i < one.strands(); ++i) {
        EXPECT_EQ(several.state(i).x, one.state(i).x) << jobs << " threads, strand " << i;
        EXPECT_EQ(several.state(i).v, one.state(i).v) << jobs << " threads, strand " << i;
      }
      EXPECT_EQ(several.work().strand_steps, one.work().strand_steps);
      EXPECT_EQ(several.work().solver_steps, one.work().solver_steps);
      EXPECT_EQ(several.work().correction_steps, one.work().correction_steps);
    }
  }
}

// Explicit steps far beyond their limit: strands break, the stiffest one first.
TEST(StrandThreadsTest, TellOfTheSameBlowUp) {
  Description description;
  for (int i = 0; i < 6; ++i)
    description.strands.push_back(straight_hair(10, 0.3 - 0.04 * i, Vector3d::UnitX()));
  description.method = Method::symplectic_euler;
  description.step = 1.0 / 240;
  Simulation one(description);
  const auto expected = one.advance(200);
  ASSERT_TRUE(expected);
  description.jobs = 3;
  Simulation several(description);
  const auto blow_up = several.advance(200);
  ASSERT_TRUE(blow_up);
  EXPECT_EQ(blow_up->strand, expected->strand);
  EXPECT_EQ(blow_up->step, expected->step);
}

}  // namespace
}  // namespace reference_tests

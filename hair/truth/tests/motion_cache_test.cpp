// STAFF ONLY. A kept motion is the same bit by bit, and belongs to its problem alone.
#include "hair/truth/motion_cache.h"
#include "hair/io/files/read_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>

#include "hair/truth/strand_ode.h"
#include "problems.h"

namespace reference_tests {
namespace {

namespace fs = std::filesystem;
using hair::AccurateMotion;
using hair::Problem;

class MotionCache : public ::testing::Test {
 protected:
  MotionCache() { fs::remove_all(folder_); }
  ~MotionCache() override { fs::remove_all(folder_); }
  MotionCache(const MotionCache&) = delete;
  MotionCache& operator=(const MotionCache&) = delete;

  AccurateMotion motion() const {
    const std::atomic<bool> interrupted = false;
    return hair::accurate_motion(level_strand(), {1e-6, folder_}, interrupted).value();
  }
  fs::path only_file() const {
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
    return fs::directory_iterator(folder_)->path();
  }
  void write(const std::string& bytes) const { std::ofstream(only_file(), std::ios::binary) << bytes; }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      (std::string("motions-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

void expect_same(const AccurateMotion& a, const AccurateMotion& b) {
  ASSERT_EQ(a.states.size(), b.states.size());
  for (std::size_t k = 0; k < a.states.size(); ++k) {
    EXPECT_EQ(a.states[k].x, b.states[k].x) << "at moment " << k;
    EXPECT_EQ(a.states[k].v, b.states[k].v) << "at moment " << k;
  }
  EXPECT_EQ(a.agreement, b.agreement);
  EXPECT_EQ(a.method, b.method);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.inextensible, b.inextensible);
}

TEST_F(MotionCache, GivesBackTheSameBits) {
  const AccurateMotion first = motion();
  EXPECT_FALSE(first.from_cache);
  const AccurateMotion second = motion();
  EXPECT_TRUE(second.from_cache);
  expect_same(first, second);
  EXPECT_EQ(first.cpu_seconds, second.cpu_seconds);
}

// A key contains forces at states that the motion never reaches.
TEST_F(MotionCache, ChangesNothing) {
  Problem hard = level_strand(200);
  hard.duration = 1e-3;  // tensions grow from nothing
  const std::atomic<bool> interrupted = false;
  const AccurateMotion alone = hair::accurate_motion(hard, {hair::kTightest, {}}, interrupted).value();
  ASSERT_TRUE(alone.inextensible);
  expect_same(alone, hair::accurate_motion(hard, {hair::kTightest, folder_}, interrupted).value());
}

// Tolerances as near to each other as people give them.
TEST_F(MotionCache, KnowsTolerancesApart) {
  const std::atomic<bool> interrupted = false;
  for (const double tolerance : {1e-6, 1.4e-6, 1.4001e-6})
    EXPECT_FALSE(hair::accurate_motion(level_strand(), {tolerance, folder_}, interrupted)->from_cache)
        << tolerance;
}

TEST_F(MotionCache, BelievesNoFileThatIsNotWhole) {
  const AccurateMotion first = motion();
  const std::string bytes = hair::bytes_of(only_file());
  ASSERT_GT(bytes.size(), 1000U);
  std::string flipped = bytes;
  flipped[bytes.size() / 2] = flipped[bytes.size() / 2] == '1' ? '2' : '1';
  for (const std::string& bad : {flipped, bytes.substr(0, bytes.size() / 2), bytes + "1", std::string(),
                                 std::string("something else")}) {
    write(bad);
    const AccurateMotion again = motion();
    EXPECT_FALSE(again.from_cache) << bad.size() << " bytes";
    expect_same(first, again);
    EXPECT_TRUE(motion().from_cache) << "written again";
  }
}

TEST_F(MotionCache, IsNoneWhereItCannotBe) {
  std::ofstream(folder_) << "a file";
  EXPECT_FALSE(motion().from_cache);
  EXPECT_FALSE(motion().from_cache);
}

TEST(MotionKey, ChangesWithAllThatAMotionDependsOn) {
  const auto key_of = [](const Problem& problem, const std::string& method = "method") {
    hair::StrandOde ode(problem);
    return hair::motion_key(problem, ode, method);
  };
  const std::string key = key_of(carried_strand());
  EXPECT_EQ(key_of(carried_strand()), key);
  std::set<std::string> keys = {key, key_of(carried_strand(), "other")};
  const std::vector<std::function<void(Problem&)>> changes = {
      [](Problem& p) { p.duration *= 1.5; },
      [](Problem& p) { p.scene.frames = 8; },
      [](Problem& p) { p.scene.hair.gravity[2] = -9.82; },
      [](Problem& p) { p.scene.hair.drag = 1e-5; },
      [](Problem& p) { p.scene.hair.strands[0].strand.mass[3] *= 1.01; },
      [](Problem& p) { p.scene.hair.strands[0].strand.rest_length[3] *= 1.01; },
      [](Problem& p) { p.scene.hair.strands[0].strand.bend_rigidity *= 1.01; },
      [](Problem& p) { p.scene.hair.strands[0].strand.stretch_rigidity *= 1.01; },
      [](Problem& p) { p.scene.hair.strands[0].strand.skip_rigidity = 1; },
      [](Problem& p) { p.scene.hair.strands[0].strand.clamped = false; },
      [](Problem& p) { p.scene.hair.strands[0].state.x[7] += 1e-9; },
      [](Problem& p) { p.scene.hair.strands[0].state.v[7] += 1e-9; },
      [](Problem& p) { p.scene.riders[0].motion.keys[1].time += 1e-9; },
      [](Problem& p) { p.scene.riders[0].motion.keys[1].pose.position[1] += 1e-9; },
      [](Problem& p) { p.scene.riders.clear(); },
  };
  for (const auto& change : changes) {
    Problem other = carried_strand();
    change(other);
    keys.insert(key_of(other));
  }
  EXPECT_EQ(keys.size(), changes.size() + 2);
}

// The same problem with forces of other code.
TEST(MotionKey, ChangesWithTheForces) {
  const Problem problem = level_strand();
  Problem bent = problem;
  bent.scene.hair.strands[0].strand.bend_rigidity *= 1 + 1e-6;  // no force at the start: it is straight
  hair::StrandOde forces(problem), others(bent);
  EXPECT_NE(hair::motion_key(problem, forces, "method"), hair::motion_key(problem, others, "method"));
}

}  // namespace
}  // namespace reference_tests

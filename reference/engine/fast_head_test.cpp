// STAFF ONLY. Compares the study's two ways to move a head: the engine, and given code with the reference's
// exercises.
#include <gtest/gtest.h>

#include <numeric>

#include "hair/lab/head/moving_head.h"

namespace hair::head_study {
namespace {

constexpr int kStrands = 12;

struct BothHeads {
  explicit BothHeads(bool collides) : head(grow_head(*bust, head_hairs()[0], kStrands)) {
    std::vector<std::size_t> all(kStrands);
    std::iota(all.begin(), all.end(), std::size_t{0});
    fast = fast_head(head, all, {bust, collides, 1});
    given = given_head(head, all, {bust, collides, 1});
    fast_points.resize(3 * kStrands * head.hair->points);
    given_points = fast_points;
  }

  void advance() {
    fast->advance();
    given->advance();
    fast->read(fast_points);
    given->read(given_points);
  }

  double apart(int strand, int point) const {
    double squares = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t at = 3 * (strand * head.hair->points + point) + axis;
      squares += (fast_points[at] - given_points[at]) * (fast_points[at] - given_points[at]);
    }
    return std::sqrt(squares);
  }

  std::shared_ptr<const Bust> bust = std::make_shared<Bust>();
  GrownHead head;
  std::unique_ptr<MovingHead> fast, given;
  std::vector<double> fast_points, given_points;
};

// Both turn by the same motion, in other arithmetic: each of 90 steps rounds a place of at most 0.2 m.
TEST(FastHead, MovesRootsAsGivenCodeDoes) {
  BothHeads heads(true);
  for (int frame = 0; frame < kSettle + kMoving; ++frame) {
    heads.advance();
    for (int k = 0; k < kStrands; ++k) EXPECT_LE(heads.apart(k, 0), 90 * 4 * 0x1p-53) << frame;
  }
}

// Both come to the same rest, under the same weight and drag. On the way they differ, since given code does
// not correct lengths. A pendulum of 36 cm with a drag of 20/s creeps to rest as exp(-(1.4 g / L) / 20 t) or
// faster; after five seconds 1e-4 of less than 0.3 m is left of each. The weight of 36 cm of hair stretches
// it by 1e-5 of itself. The engine's segments have one length, and given code's are as the hair grew: that
// moves a point by the segments' differences from their mean.
TEST(FastHead, ComesToRestWhereGivenCodeDoes) {
  BothHeads heads(false);
  for (int frame = 0; frame < 5 * kFramesPerSecond; ++frame) heads.advance();
  const int points = heads.head.hair->points;
  for (int k = 0; k < kStrands; ++k) {
    const Eigen::VectorXd& x = heads.head.strands[k];
    Eigen::VectorXd lengths(points - 1);
    for (int i = 0; i < points - 1; ++i) lengths[i] = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    const double unlike = (lengths.array() - lengths.mean()).abs().sum();
    for (int i = 0; i < points; ++i) EXPECT_LE(heads.apart(k, i), 2 * 3e-5 + 4e-6 + unlike) << k << " " << i;
  }
}

TEST(FastHead, IsForSegmentsOfAboutOneLength) {
  const auto bust = std::make_shared<const Bust>();
  GrownHead head = grow_head(*bust, head_hairs()[0], 1);
  const std::size_t first = 0;
  EXPECT_NE(fast_head(head, {&first, 1}, {bust, true, 1}), nullptr);
  Eigen::VectorXd& x = head.strands[0];
  x.segment<3>(3) = (x.head<3>() + x.segment<3>(3)) / 2;
  EXPECT_THROW(fast_head(head, {&first, 1}, {bust, true, 1}), std::invalid_argument);
}

TEST(FastHead, IsForStraightHair) {
  const auto bust = std::make_shared<const Bust>();
  const GrownHead curls = grow_head(*bust, head_hairs()[3], 1);
  const std::size_t first = 0;
  EXPECT_EQ(fast_head(curls, {&first, 1}, {bust, true, 1}), nullptr);
}

}  // namespace
}  // namespace hair::head_study

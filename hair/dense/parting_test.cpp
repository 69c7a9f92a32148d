// STAFF ONLY. Hair that a parting divides.
#include <gtest/gtest.h>

#include "hair/dense/synthesis.h"
#include "hair/dense/test_guides.h"

namespace reference_tests {
namespace {

using hair::Parents, hair::Synthesis, hair::SynthesisDescription, hair::SynthesisMode;

constexpr int kPointsOfParted = 6;

// On a disc, hair left of the line x = 0 is combed to the left, and the other to the right.
std::vector<RootFrame> parted(std::vector<RootFrame> roots) {
  for (RootFrame& root : roots) root.side = Vector3d(root.position.x() < 0 ? -1 : 1, 0, 0);
  return roots;
}

SynthesisDescription parted_disc(SynthesisMode mode) {
  return {.guides = parted(roots_on_disc(60, 0.1)),
          .children = parted(roots_on_disc(1500, 0.095)),
          .points = kPointsOfParted,
          .mode = mode,
          .combed = true};
}

// Each guide goes 3 cm up and 10 cm to its side.
VectorXd combed_guides(const std::vector<RootFrame>& roots) {
  VectorXd x(static_cast<Eigen::Index>(3 * kPointsOfParted * roots.size()));
  Eigen::Index at = 0;
  for (const RootFrame& root : roots)
    for (int i = 0; i < kPointsOfParted; ++i, at += 3)
      x.segment<3>(at) = root.position + static_cast<double>(i) / (kPointsOfParted - 1) *
                                             (0.03 * root.axis + 0.1 * root.side);
  return x;
}

TEST(Parting, NoStrandGrowsBetweenItsTwoSides) {
  for (const SynthesisMode mode :
       {SynthesisMode::interpolate, SynthesisMode::extrapolate, SynthesisMode::blend}) {
    const SynthesisDescription description = parted_disc(mode);
    Synthesis synthesis(description);
    const VectorXd guides = combed_guides(description.guides);
    std::vector<double> made(3 * kPointsOfParted * description.children.size());
    synthesis.make({guides.data(), static_cast<std::size_t>(guides.size())}, Eigen::Matrix3d::Identity(), {},
                   std::span<double>(made));
    for (std::size_t child = 0; child < description.children.size(); ++child) {
      const RootFrame& root = description.children[child];
      const double tip = made[3 * (kPointsOfParted * (child + 1) - 1)];
      ASSERT_NEAR(tip, root.position.x() + 0.1 * root.side.x(), 1e-12)
          << "a strand between guides that all go to its side goes there, too; child " << child;
    }
  }
}

TEST(Parting, WeightsAreOfItsOwnSideAndTheirSumIs1) {
  const SynthesisDescription description = parted_disc(SynthesisMode::blend);
  Synthesis synthesis(description);
  int alone = 0;
  for (int child = 0; child < synthesis.children(); ++child) {
    const Parents& parents = synthesis.parents(child);
    const Vector3d& side = description.children[static_cast<std::size_t>(child)].side;
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(parents.weights[k], 0);
      EXPECT_GT(description.guides[static_cast<std::size_t>(parents.guides[k])].side.dot(side), 0);
      sum += parents.weights[k];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    alone += parents.guides[1] == parents.guides[0] ? 1 : 0;
  }
  EXPECT_GT(alone, 0) << "some triangles have one corner on a strand's side";
}

// A strand whose whole triangle is on the other side takes the nearest guide of its own side.
TEST(Parting, AStrandThatIsAloneTakesTheNearestGuideOfItsSide) {
  SynthesisDescription description = parted_disc(SynthesisMode::interpolate);
  description.children = {{Vector3d(0.05, 0, 0), description.children.front().axis, Vector3d(-1, 0, 0)}};
  const int guide = Synthesis(description).parents(0).guides[0];
  for (const RootFrame& other : description.guides)
    if (other.side.x() < 0) {
      EXPECT_LE(
          (description.guides[static_cast<std::size_t>(guide)].position - description.children[0].position)
              .norm(),
          (other.position - description.children[0].position).norm());
    }
  EXPECT_LT(description.guides[static_cast<std::size_t>(guide)].side.x(), 0);
}

}  // namespace
}  // namespace reference_tests

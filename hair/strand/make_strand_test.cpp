#include "hair/strand/make_strand.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "solver/test_numbers.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

using reference_tests::kUnit;

// The message with which a call refuses its input; "" if it accepts it.
std::string refusal(const std::function<void()>& call) {
  return tests::refusal<std::invalid_argument>([&] { call(); });
}

TEST(MakeStrand, MassesAreHalfOfTheSegmentsBesideThem) {
  const Material hair;
  const Strand strand = uniform_strand(hair, 30, 0.3);
  const double segment = hair.line_density() * 0.3 / 30;
  ASSERT_EQ(strand.count(), 31);
  ASSERT_EQ(strand.segments(), 30);
  EXPECT_DOUBLE_EQ(strand.mass[0], segment / 2);
  EXPECT_DOUBLE_EQ(strand.mass[30], segment / 2);
  for (int i = 1; i < 30; ++i) EXPECT_DOUBLE_EQ(strand.mass[i], segment);
  // A sum of 31 terms is within 31 u of itself; each mass has 4 roundings.
  EXPECT_NEAR(strand.mass.sum(), hair.line_density() * 0.3, 40 * kUnit * strand.mass.sum());
}

TEST(MakeStrand, RefiningChangesNeitherMassNorLengthNorRigidity) {
  const Strand coarse = uniform_strand({}, 10, 0.3), fine = uniform_strand({}, 80, 0.3);
  EXPECT_NEAR(fine.mass.sum(), coarse.mass.sum(), 100 * kUnit * coarse.mass.sum());
  EXPECT_NEAR(fine.rest_length.sum(), 0.3, 100 * kUnit);
  EXPECT_EQ(fine.stretch_rigidity, coarse.stretch_rigidity);
  EXPECT_EQ(fine.bend_rigidity, coarse.bend_rigidity);
}

TEST(MakeStrand, HumanHairHasTheTextbooksRigidities) {
  const Strand strand = uniform_strand({}, 1, 0.1);
  EXPECT_NEAR(strand.stretch_rigidity, 3e9 * std::numbers::pi * 25e-10, 1e-12);     // E pi R^2
  EXPECT_NEAR(strand.bend_rigidity, 3e9 * std::numbers::pi * 6.25e-18 / 4, 1e-20);  // E pi R^4 / 4
}

TEST(MakeStrand, RestLengthsAreDistances) {
  Eigen::VectorXd x(9);
  x << 1, 2, 3, 1, 2, 5, 4, 6, 5;
  const Strand strand = strand_from_rest({}, x);
  EXPECT_DOUBLE_EQ(strand.rest_length[0], 2);
  EXPECT_DOUBLE_EQ(strand.rest_length[1], 5);
  EXPECT_DOUBLE_EQ(strand.mass[1] / strand.mass[0], 3.5);
  EXPECT_DOUBLE_EQ(strand.mass[2] / strand.mass[0], 2.5);
}

TEST(MakeStrand, ALoneParticleHasAMass) {
  const Strand strand = strand_from_rest({}, Eigen::VectorXd::Zero(3));
  EXPECT_EQ(strand.segments(), 0);
  EXPECT_GT(strand.mass[0], 0);
}

TEST(MakeStrand, BadInputIsNamedWithItsValueAndBound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([] { uniform_strand({}, 0, 1); }),
            "a strand's segments is 0; it must be finite and at least 1");
  EXPECT_EQ(refusal([] { uniform_strand({}, 3, -1); }), "a strand's length is -1; it must be finite and > 0");
  EXPECT_EQ(refusal([&] { uniform_strand({}, 3, nan); }),
            "a strand's length is nan; it must be finite and > 0");
  EXPECT_EQ(refusal([] { uniform_strand({.radius = 0}, 3, 1); }),
            "a material's radius is 0; it must be finite and > 0");
  EXPECT_EQ(refusal([] { uniform_strand({.density = -5}, 3, 1); }),
            "a material's density is -5; it must be finite and > 0");
  EXPECT_EQ(refusal([] { uniform_strand({.young_modulus = 0}, 3, 1); }),
            "Young's modulus is 0; it must be finite and > 0");
  EXPECT_NE(refusal([] { uniform_strand({.radius = 1e-200}, 3, 1); }), "");  // masses underflow
  EXPECT_EQ(refusal([] { strand_from_rest({}, Eigen::VectorXd()); }),
            "the numbers in a strand's positions is 0; it must be finite and at least 3");
  EXPECT_EQ(refusal([] { strand_from_rest({}, Eigen::VectorXd::Zero(4)); }),
            "the numbers in a strand's positions is 4; it must be a multiple of 3");
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(9, 0, 1);
  x.tail<3>() = x.segment<3>(3);
  EXPECT_EQ(refusal([&] { strand_from_rest({}, x); }),
            "the rest length of segment 1 is 0; it must be finite and > 0");
  x[4] = nan;
  EXPECT_EQ(refusal([&] { strand_from_rest({}, x); }), "a strand's position is nan; it must be finite");
}

}  // namespace
}  // namespace hair

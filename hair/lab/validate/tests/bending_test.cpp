// STAFF ONLY. Validations with bending: the reference bends as theory says, and slightly wrong clamps and
// masses are detected.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hair/lab/validate/bending_validations.h"
#include "hair/lab/validate/clamped_beam.h"
#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/elastica.h"
#include "hair/lab/validate/greenhill.h"
#include "hair/lab/validate/planar_statics.h"
#include "hair/lab/validate/record.h"

namespace hair {
namespace {

class Bending : public testing::TestWithParam<Validation> {};

TEST_P(Bending, IsAsTheorySays) {
  const ValidationResult result = GetParam().run({true, nullptr});
  EXPECT_FALSE(result.checks.empty());
  for (const Check& check : result.checks)
    EXPECT_TRUE(check.holds()) << check.shows << ": expected " << check.expected << ", measured "
                               << check.measured << ", off by " << check.error() << ", allowed "
                               << check.tolerance << " (" << check.tolerance_from << ")";
}

INSTANTIATE_TEST_SUITE_P(All, Bending, testing::ValuesIn(bending_validations()), [](const auto& test) {
  std::string name = test.param.id;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(BendingAgain, IsTheSameButForTimes) {
  const auto json = [] {
    ValidationResult result = hair_at_rest().run({true, nullptr});
    EXPECT_FALSE(result.times.empty());
    result.times.clear();
    return record_text(json_of(std::vector{ValidationRecord{"elastica", "", {}, result}}));
  };
  EXPECT_EQ(json(), json());
}

// --- Wrong models ---

// Weakens the clamp's spring: the energy -stiffness * angle^2 / 2 of the first segment below level.
class WeakerClamp final : public particles::Force {
 public:
  explicit WeakerClamp(double stiffness) : stiffness_(stiffness) {}
  double energy(particles::Input x) const override { return -stiffness_ * angle(x) * angle(x) / 2; }
  void add_force(particles::Input x, particles::Input, particles::Output f) const override {
    f.segment<3>(3) += stiffness_ * angle(x) * slope(x);
  }
  void add_dfdx(particles::Input x, particles::Input, particles::Input dx,
                particles::Output df) const override {
    const Vector3d e = x.segment<3>(3), de = dx.segment<3>(3), turned(-de[2], 0, de[0]);
    const Vector3d change = turned / e.squaredNorm() - 2 * e.dot(de) / e.squaredNorm() * slope(x);
    df.segment<3>(3) += stiffness_ * (slope(x).dot(de) * slope(x) + angle(x) * change);
  }
  void add_dfdv(particles::Input, particles::Input, particles::Input, particles::Output) const override {}

 private:
  static double angle(particles::Input x) { return std::atan2(x[5], x[3]); }
  static Vector3d slope(particles::Input x) {
    const Vector3d e = x.segment<3>(3);
    return Vector3d(-e[2], 0, e[0]) / e.squaredNorm();
  }

  double stiffness_;
};

// The tip's error at Gamma = 1, after a change of the strand or its forces.
template <typename Change>
double tip_error(int segments, const Change& change) {
  const Material material;
  const double length = length_of(material, 1);
  StrandStart start = clamped_hair(material, segments, length, Vector3d::UnitX());
  const auto strand = change(start);
  const Balance balance = planar_balance(strand->strand, strand->force, start.state.x);
  EXPECT_TRUE(balance.found()) << segments << " segments: " << balance.residual << " N is left";
  return (planar_tip(balance.x) / length - elastica(1).tip()).norm();
}

template <typename Change>
double order(const Change& change) {
  return std::log2(tip_error(40, change) / tip_error(80, change));
}

const Vector3d kGravity(0, 0, -kEarthGravity);

// An error a/n + b/n^2 has the order 1 + (b/a) / 80 log(2) from n = 40 to 80: 0.018 b/a more than 1.
constexpr double kAboutOne = 0.05;

TEST(BendingThatIsWrong, AsItIsTheOrderIsTwo) {
  EXPECT_NEAR(order([](const StrandStart& start) { return under_gravity(start, kGravity); }), 2, 1e-3);
}

TEST(BendingThatIsWrong, AClampThatBendsAWholeSegmentHasOrderOne) {
  EXPECT_NEAR(order([](const StrandStart& start) {
                auto strand = under_gravity(start, kGravity);
                strand->force.emplace<WeakerClamp>(start.strand.bend_rigidity / start.strand.rest_length[0]);
                return strand;
              }),
              1, kAboutOne);
}

TEST(BendingThatIsWrong, AWholeSegmentsMassAtTheTipHasOrderOne) {
  EXPECT_NEAR(order([](StrandStart& start) {
                start.strand.mass[start.strand.segments()] *= 2;
                return under_gravity(start, kGravity);
              }),
              1, kAboutOne);
}

// The relative error of a mode's frequency, over theory's.
double frequency_error(int segments, int mode, const StrandStart& start) {
  const double length = start.strand.rest_length.sum();
  const double root = beam_root_of({}, length, beam_modes(start).frequencies[mode - 1]);
  return (std::pow(root / clamped_beam_root(mode), 4) - 1) /
         (-clamped_beam_error(mode) / (segments * segments));
}

TEST(BendingThatIsWrong, FrequenciesOfAWholeSegmentsMassAtTheTipAreTooLow) {
  for (int mode : {1, 2, 3}) {
    StrandStart start = clamped_hair({}, 80, 0.05, Vector3d::UnitX());
    EXPECT_NEAR(frequency_error(80, mode, start), 1, 0.01) << mode;
    start.strand.mass[80] *= 2;
    EXPECT_GT(frequency_error(80, mode, start), 5) << mode;
  }
}

// Gamma is accurate to the error's next term, about its square, and to W / EA of the height, cubed: 2.8e-5
// for 10 segments.
TEST(BendingThatIsWrong, HairThatIsHeavierByATenThousandthBucklesWhereItShouldStand) {
  const Material material;
  const double height = length_of(material, (1 - 5e-5) * strand_greenhill(10));
  EXPECT_GT(softest_stiffness(standing_hair(material, 10, height)), 0);
  Material heavier = material;
  heavier.density *= 1 + 1e-4;
  EXPECT_LT(softest_stiffness(standing_hair(heavier, 10, height)), 0);
}

}  // namespace
}  // namespace hair

// STAFF ONLY. A strand that is too stiff to stretch moves like one that does not stretch.
#include <gtest/gtest.h>

#include <cmath>

#include "hair/strand/make_strand.h"
#include "hair/truth/rigid_strand_ode.h"
#include "problems.h"

namespace reference_tests {
namespace {

using hair::AccurateMotion;
using hair::Problem;

TEST(RigidStrand, KeepsItsLengths) {
  for (const Problem& problem : {level_strand(1e6), carried_strand(1e6)}) {
    const AccurateMotion motion = motion_of(problem);
    ASSERT_TRUE(motion.inextensible);
    const hair::Strand& strand = problem.scene.hair.strands[0].strand;
    for (const particles::State& state : motion.states) {
      for (int i = 0; i < strand.segments(); ++i) {
        const hair::Vector3d e = state.x.segment<3>(3 * i + 3) - state.x.segment<3>(3 * i);
        const hair::Vector3d de = state.v.segment<3>(3 * i + 3) - state.v.segment<3>(3 * i);
        EXPECT_NEAR(e.norm() / strand.rest_length[i], 1, 1e-14);
        EXPECT_NEAR(e.normalized().dot(de), 0, 1e-14 * (1 + state.v.norm()));
      }
    }
    EXPECT_GT((motion.states.back().x - motion.states.front().x).norm(), 0.01) << "it did move";
    EXPECT_LE(motion.agreement, hair::kLeastError);
  }
}

// To first order in 1/EA, the distance from the limit is the stretch by tensions: ten times the EA, a
// tenth of it. And the agreement of a rigid strand's motion covers this distance.
TEST(RigidStrand, IsTheLimitOfThoseThatStretchAndSaysHowFarItIs) {
  constexpr double kSoft = 0.003, kHard = 0.03, kHardest = 101;
  for (Problem (*make)(double) : {level_strand, carried_strand}) {
    const AccurateMotion limit = motion_of(make(kHardest));
    ASSERT_TRUE(limit.inextensible);
    const double soft = hair::largest_distance(motion_of(make(kSoft), 1e-10).states, limit.states);
    const double hard = hair::largest_distance(motion_of(make(kHard), 1e-10).states, limit.states);
    EXPECT_NEAR(hard / soft, kSoft / kHard, 0.02) << soft << " m, then " << hard << " m";
    const double hardest = hard * kHard / kHardest;
    EXPECT_LE(hardest, limit.agreement);
    EXPECT_GE(hardest, limit.agreement / 20) << "else it says too much";
  }
}

TEST(RigidStrand, HairIsAsHardAsHairWhateverItsRadius) {
  for (const double radius : {20e-6, 50e-6, 1e-3}) {
    hair::Material material;
    material.radius = radius;
    EXPECT_NEAR(hair::times_the_ea_of_hair(hair::uniform_strand(material, 7, 0.1)), 1, 1e-12);
    material.young_modulus *= 1000;
    EXPECT_NEAR(hair::times_the_ea_of_hair(hair::uniform_strand(material, 7, 0.1)), 1000, 1e-9);
  }
}

TEST(RigidStrand, IsNoLimitOfOneThatStartsStretched) {
  Problem problem = level_strand(1e6);
  EXPECT_TRUE(hair::starts_rigid(problem));
  problem.scene.hair.strands[0].state.x[3] += 1e-6;
  EXPECT_FALSE(hair::starts_rigid(problem));
  problem = level_strand(1e6);
  problem.scene.hair.strands[0].state.v[3] = 1e-3;
  EXPECT_FALSE(hair::starts_rigid(problem));
  problem = level_strand(1e6);
  problem.scene.hair.strands[0].state.v[5] = 1;  // across
  EXPECT_TRUE(hair::starts_rigid(problem));
}

}  // namespace
}  // namespace reference_tests

// STAFF ONLY. H9 beyond its public checks: links turn with the hair, they limit only explicit steps, and
// nothing allocates. Sizes are 1, so bounds of 1e-12 are thousands of roundings.

#include "hair/static_links.h"

#include <gtest/gtest.h>

#include <vector>

#include "handout/check/derivative.h"
#include "solver/test_allocations.h"

namespace reference_tests {
namespace {

using checks::scattered_vector;
using Eigen::VectorXd;
using hair::Matrix3d, hair::StaticLink, hair::StripContact, hair::StripLaw, hair::Vector3d;

constexpr double kRounding = 1e-12;

Matrix3d turn(double angle, int which) {
  return Eigen::AngleAxisd(angle, Vector3d(scattered_vector(3, which)).normalized()).toRotationMatrix();
}

// One particle is linked to a held one. Symplectic Euler is stable only if h^2 k / m < 4; implicit Euler,
// (m + h^2 k) v' = m v + h f, is stable at any stiffness.
TEST(StaticLinks, LimitExplicitStepsButNotImplicitOnes) {
  const std::vector<Matrix3d> frames(2, turn(1, 3));
  const Eigen::Matrix<double, 1, 1> unworn(0.0);
  const auto largest_distance = [&](double h2k_per_m, bool implicit) {
    const std::vector<StaticLink> links = {{0, 1, Vector3d(0, 1, 0), 1, h2k_per_m, 1e300, 1e300}};
    VectorXd x(6), v = VectorXd::Zero(6), f(6);
    x << Vector3d::Zero(), frames[0] * links[0].offset + Vector3d(0.1, 0, 0);
    double most = 0;
    for (int step = 0; step < 1000; ++step) {  // h = m = 1
      f.setZero();
      add_link_force(links, frames, unworn, x, f);
      v.tail<3>() += f.tail<3>();
      if (implicit) {
        f.setZero();
        add_link_product(links, unworn, VectorXd::Unit(6, 3), f);
        v.tail<3>() = (v.tail<3>() / (1 - f[3])).eval();
      }
      x.tail<3>() += v.tail<3>();
      most = std::max(most, (x.tail<3>() - frames[0] * links[0].offset).norm());
    }
    return most;
  };
  EXPECT_LE(largest_distance(3.9, false), 1);    // 0.1 / sqrt(1 - 3.9 / 4) = 0.63
  EXPECT_GE(largest_distance(4.1, false), 1e6);  // it grows by 1.37 each step
  EXPECT_LE(largest_distance(4.1, true), 0.1);
  EXPECT_LE(largest_distance(4e6, true), 0.1);
}

TEST(StaticLinks, AllocateNothing) {
  const std::vector<StaticLink> links = {{0, 1, Vector3d(0.2, -0.4, 0.1), 0.5, 2, 1, 2},
                                         {3, 1, Vector3d(0.3, 0.1, 0.2), 0.6, 3, 1, 2.5}};
  const std::vector<Matrix3d> frames(4, turn(1, 3));
  const StripLaw law{10, 5, 0.3};
  StripContact contact;
  // The second link is broken.
  VectorXd f = VectorXd::Zero(12), largest = Eigen::Vector2d(0.5, 2.6), x = scattered_vector(12, 1);
  const VectorXd inverse_mass = VectorXd::Ones(4), tangents = VectorXd::Zero(12), dx = x;
  x.segment<3>(9) = (x.segment<3>(0) + x.segment<3>(3) + x.segment<3>(6)) / 3;
  const long before = allocations();
  ASSERT_GT(before, 0) << "nothing is counted";
  remember_stretches(links, frames, x, largest);
  double energy = link_energy(links, frames, largest, x);
  add_link_force(links, frames, largest, x, f);
  add_link_product(links, largest, dx, f);
  EXPECT_TRUE(touch_strip(3, {0, 1, 2}, 1, law.thickness, x, tangents, contact));
  const std::span<const StripContact> contacts(&contact, 1);
  energy += strip_energy(contacts, law, x);
  add_strip_force(contacts, law, x, f);
  add_strip_product(contacts, law, x, dx, f);
  apply_strip_friction(contacts, law, inverse_mass, 0.1, x, f);
  EXPECT_EQ(allocations(), before) << energy;
}

}  // namespace
}  // namespace reference_tests

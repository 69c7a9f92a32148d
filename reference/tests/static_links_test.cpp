// STAFF ONLY. What hair/static_links.h promises, and what physics does. Sizes are 1: bounds of 1e-12 are thousands of
// roundings, 1e-6 is what central differences leave (handout/checks/derivative.h).

#include "hair/static_links.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "handout/checks/derivative.h"
#include "solver/symmetric_eigen.h"
#include "solver/tests/allocations.h"

namespace reference_tests {
namespace {

using checks::scattered_vector;
using Eigen::MatrixXd, Eigen::VectorXd;
using hair::Matrix3d, hair::StaticLink, hair::StripContact, hair::StripLaw, hair::Vector3d;

constexpr double kRounding = 1e-12;

Matrix3d turn(double angle, int which) {
  return Eigen::AngleAxisd(angle, Vector3d(scattered_vector(3, which)).normalized()).toRotationMatrix();
}

Vector3d sum_of(const VectorXd& f) {
  return f.reshaped(3, f.size() / 3).rowwise().sum();
}

Vector3d torque_of(const VectorXd& x, const VectorXd& f) {
  Vector3d torque = Vector3d::Zero();
  for (Eigen::Index at = 0; at < x.size(); at += 3)
    torque += Vector3d(x.segment<3>(at)).cross(Vector3d(f.segment<3>(at)));
  return torque;
}

// Of energy(x), force(x) and product(dx) of 7 particles at x.
template <class System>
void expect_central_differences(const System& s) {
  ASSERT_GT(s.energy(s.x), 0);
  checks::expect_force(
      s.force(s.x), [&](const VectorXd& x) { return s.energy(x); }, s.x, 1, 10);
  for (int which = 0; which < 4; ++which) {
    const VectorXd dx = scattered_vector(21, 30 + which);
    checks::expect_product(
        s.product(dx), [&](const VectorXd& x) { return s.force(x); }, s.x, dx, 1, 10);
  }
}

// -df/dx is symmetric and has no negative eigenvalue.
template <class System>
void expect_definite_product(const System& s) {
  MatrixXd K(21, 21);
  for (int i = 0; i < 21; ++i) K.col(i) = -s.product(VectorXd::Unit(21, i));
  EXPECT_GT(K.norm(), 1);
  EXPECT_LE((K - K.transpose()).norm(), kRounding);
  EXPECT_GE(solver::symmetric_eigenvalues(K).minCoeff(), -20 * kRounding);
}

// Seven particles, five links between them: new, worn, broken; some share particles.
struct Linked {
  Linked() {
    for (int i = 0; i < 7; ++i) frames.push_back(turn(0.5 * i, i));
    const std::array<std::array<int, 2>, 5> ends = {{{0, 1}, {1, 2}, {6, 0}, {3, 5}, {5, 4}}};
    for (int l = 0; l < 5; ++l)
      links.push_back(
          {ends[l][0], ends[l][1], scattered_vector(3, 10 + l), 0.5 + 0.1 * l, 2.0 + l, 1, 2.0 + 0.5 * l});
    largest << 0.5, 1, 1.5, 3, 9;
  }
  double energy(const VectorXd& at) const { return link_energy(links, frames, largest, at); }
  VectorXd force(const VectorXd& at) const {
    VectorXd f = VectorXd::Zero(21);
    add_link_force(links, frames, largest, at, f);
    return f;
  }
  VectorXd product(const VectorXd& dx) const {
    VectorXd df = VectorXd::Zero(21);
    add_link_product(links, largest, dx, df);
    return df;
  }

  std::vector<StaticLink> links;
  std::vector<Matrix3d> frames;
  VectorXd x = scattered_vector(21, 1), largest = VectorXd(5);
};

TEST(StaticLinks, StrengthFallsFromOneToZero) {
  StaticLink link;
  link.yields = 1;
  link.breaks = 3;
  for (const auto& [largest, strength] :
       {std::pair(0.0, 1.0), {1.0, 1.0}, {1.5, 0.75}, {2.0, 0.5}, {3.0, 0.0}, {50.0, 0.0}})
    EXPECT_EQ(link_strength(link, largest), strength) << "largest stretch " << largest;
  link.breaks = 1;
  EXPECT_EQ(link_strength(link, 1), 1) << "yields = breaks";
  EXPECT_EQ(link_strength(link, std::nextafter(1, 2)), 0) << "yields = breaks";
}

// A link that is stretched and released stays as weak as it was; one that is broken exerts exactly nothing.
TEST(StaticLinks, NeverHeal) {
  const std::vector<StaticLink> links = {{0, 1, Vector3d(1, 0, 0), 1, 10, 0.5, 1.5}};
  const std::vector<Matrix3d> frames(2, Matrix3d::Identity());
  VectorXd largest = VectorXd::Zero(1), x = VectorXd::Zero(6);
  double before = 1;
  for (const double at : {1.0, 1.4, 1.9, 1.2, 1.0, 2.1, 0.3, 2.6, 1.5}) {
    x[3] = at;
    remember_stretches(links, frames, x, largest);
    const double strength = link_strength(links[0], largest[0]);
    EXPECT_LE(strength, before) << "with the particle at " << at;
    EXPECT_GE(largest[0], std::abs(at - 1));
    before = strength;
  }
  EXPECT_EQ(before, 0);
  VectorXd f = VectorXd::Zero(6);
  add_link_force(links, frames, largest, x, f);
  add_link_product(links, largest, x, f);
  EXPECT_EQ(f, VectorXd::Zero(6));
  EXPECT_EQ(link_energy(links, frames, largest, x), 0);
}

TEST(StaticLinks, AgreeWithCentralDifferences) {
  expect_central_differences(Linked());
}

TEST(StaticLinks, PushAsMuchAsTheyPull) {
  const Linked s;
  EXPECT_LE(sum_of(s.force(s.x)).norm(), 20 * kRounding);
  EXPECT_LE(sum_of(s.product(s.x)).norm(), 20 * kRounding);
}

// What turns and moves as a whole, frames too, has forces that turn with it.
TEST(StaticLinks, TurnWithTheHair) {
  Linked s;
  const Matrix3d R = turn(1.2, 77);
  VectorXd expected = s.force(s.x);
  const double energy = s.energy(s.x);
  for (int i = 0; i < 7; ++i) {
    s.x.segment<3>(3 * i) = (R * s.x.segment<3>(3 * i)).eval() + Vector3d(1, -2, 0.5);
    expected.segment<3>(3 * i) = (R * expected.segment<3>(3 * i)).eval();
    s.frames[i] = R * s.frames[i];
  }
  EXPECT_LE((s.force(s.x) - expected).norm(), 100 * kRounding);
  EXPECT_NEAR(s.energy(s.x), energy, 100 * kRounding);
}

TEST(StaticLinks, HaveADefiniteProduct) {
  expect_definite_product(Linked());
}

// One particle, linked to one that is held. Symplectic Euler keeps it if h^2 k / m < 4 and no longer;
// implicit Euler, (m + h^2 k) v' = m v + h f, at any stiffness.
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

// ---- Strips

// A point over a triangle, which `gap` and `foot` place.
struct Touched {
  explicit Touched(double gap, const Vector3d& foot = Vector3d(0.5, 0.3, 0.2)) {
    x.tail<3>() = gap * normal();
    for (int j = 0; j < 3; ++j) x.tail<3>() += foot[j] * x.segment<3>(3 * j);
  }
  Vector3d normal() const {
    const Vector3d a = x.head<3>();
    return (x.segment<3>(3) - a).cross(x.segment<3>(6) - a).normalized();
  }
  bool touch(double side, double thickness) {
    return touch_strip(3, {0, 1, 2}, side, thickness, x, tangents, contact);
  }

  VectorXd x = scattered_vector(12, 5), tangents = VectorXd::Zero(12);
  StripContact contact;
};

TEST(TriangleStrips, SeeAPointOverThem) {
  for (const double side : {1.0, -1.0})
    for (const double gap : {0.2, -0.1}) {
      Touched s(gap);
      ASSERT_TRUE(s.touch(side, 0.3));
      EXPECT_LE((s.contact.normal - side * s.normal()).norm(), kRounding);
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(s.contact.shares[j], Vector3d(0.5, 0.3, 0.2)[j], 100 * kRounding);
      EXPECT_EQ(s.contact.weight, 1) << "without tangents";
    }
}

TEST(TriangleStrips, SeeNothingElsewhere) {
  EXPECT_FALSE(Touched(0.31).touch(1, 0.3));
  EXPECT_FALSE(Touched(-0.31).touch(1, 0.3));
  EXPECT_FALSE(Touched(0.1, Vector3d(1.1, -0.2, 0.1)).touch(1, 0.3));
  EXPECT_FALSE(Touched(0.1, Vector3d(-0.1, 0.5, 0.6)).touch(1, 0.3));
  EXPECT_FALSE(Touched(0.1, Vector3d(0.5, 0.6, -0.1)).touch(1, 0.3));
  Touched flat(0.1);
  flat.x.segment<3>(6) = flat.x.segment<3>(3);
  EXPECT_FALSE(flat.touch(1, 10)) << "a triangle without an area";
}

// Turned end for end, no hair touches otherwise.
TEST(TriangleStrips, WeighDirectionsAndNotTheirSigns) {
  Touched s(0.1);
  const Vector3d along(0, 0, 1), across(1, 0, 0), between = Vector3d(0, 3, 4) / 5;
  const auto weight = [&](const Vector3d& point, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    s.tangents << a, b, c, point;
    EXPECT_TRUE(s.touch(1, 0.3));
    return s.contact.weight;
  };
  EXPECT_NEAR(weight(along, along, along, along), 0, kRounding) << "parallel";
  EXPECT_NEAR(weight(-along, along, along, along), 0, kRounding) << "antiparallel";
  EXPECT_NEAR(weight(along, along, -along, along), 0, kRounding) << "a corner's hair is turned end for end";
  EXPECT_NEAR(weight(along, across, across, -across), 1, kRounding) << "crossing";
  EXPECT_NEAR(weight(along, between, along, across), 1 - 0.5 * 0.8 - 0.3, 100 * kRounding);
  EXPECT_GE(weight(along * (1 + 1e-15), along, along, along), 0);
}

// Several contacts that share particles, pressed and free.
struct Pressed {
  Pressed() {
    const std::array<std::array<int, 4>, 5> ends = {
        {{3, 0, 1, 2}, {4, 2, 1, 0}, {5, 0, 1, 2}, {0, 3, 4, 5}, {6, 1, 3, 5}}};
    for (int c = 0; c < 5; ++c) {
      Vector3d shares = scattered_vector(3, 50 + c).cwiseAbs() + Vector3d::Constant(0.1);
      shares /= shares.sum();
      contacts.push_back({ends[c][0],
                          {ends[c][1], ends[c][2], ends[c][3]},
                          {shares[0], shares[1], shares[2]},
                          Vector3d(scattered_vector(3, 60 + c)).normalized(),
                          0.3 + 0.1 * c});
    }
  }
  double energy(const VectorXd& at) const { return strip_energy(contacts, law, at); }
  VectorXd force(const VectorXd& at) const {
    VectorXd f = VectorXd::Zero(21);
    add_strip_force(contacts, law, at, f);
    return f;
  }
  VectorXd product(const VectorXd& dx) const {
    VectorXd df = VectorXd::Zero(21);
    add_strip_product(contacts, law, x, dx, df);
    return df;
  }

  std::vector<StripContact> contacts;
  StripLaw law{0.4, 5, 0.3};
  VectorXd x = scattered_vector(21, 8);
};

TEST(TriangleStrips, AgreeWithCentralDifferences) {
  expect_central_differences(Pressed());
}

TEST(TriangleStrips, HaveADefiniteProduct) {
  expect_definite_product(Pressed());
}

TEST(TriangleStrips, PushAsMuchAsTheyArePushed) {
  const Pressed s;
  EXPECT_LE(sum_of(s.force(s.x)).norm(), 20 * kRounding);
  Touched one(0.1);
  ASSERT_TRUE(one.touch(1, 0.3));
  VectorXd f = VectorXd::Zero(12);
  add_strip_force(std::span(&one.contact, 1), {0.3, 7, 0}, one.x, f);
  EXPECT_NEAR(f.tail<3>().norm(), 7 * 0.2, 20 * kRounding);
  EXPECT_GT(f.tail<3>().dot(one.normal()), 0) << "away from the triangle";
  EXPECT_LE(torque_of(one.x, f).norm(), 20 * kRounding) << "the point is right above what it pushes";
}

double kinetic(const VectorXd& inverse_mass, const VectorXd& v) {
  double energy = 0;
  for (Eigen::Index i = 0; i < inverse_mass.size(); ++i)
    if (inverse_mass[i] > 0) energy += v.segment<3>(3 * i).squaredNorm() / inverse_mass[i] / 2;
  return energy;
}

TEST(StripFriction, NeverAccelerates) {
  const Pressed s;
  for (int which = 0; which < 20; ++which)
    for (const double h : {1e-3, 0.1, 1e3}) {
      VectorXd inverse_mass = scattered_vector(7, 100 + which).cwiseAbs(),
               v = scattered_vector(21, 200 + which);
      if (which % 3 == 0) {  // pinned where it is: one that moves would do work
        inverse_mass[which % 7] = 0;
        v.segment<3>(3 * (which % 7)).setZero();
      }
      const VectorXd before = v;
      apply_strip_friction(s.contacts, s.law, inverse_mass, h, s.x, v);
      EXPECT_NE(v, before);
      EXPECT_LE(kinetic(inverse_mass, v), kinetic(inverse_mass, before) * (1 + kRounding));
      VectorXd momentum = v - before;
      for (int i = 0; i < 7; ++i) momentum.segment<3>(3 * i) *= inverse_mass[i] > 0 ? 1 / inverse_mass[i] : 0;
      if (which % 3 != 0) {
        EXPECT_LE(sum_of(momentum).norm(), 1000 * kRounding);
      }
    }
}

// Below Coulomb's bound the point stops on the strip, above it slips with the bound's force.
TEST(StripFriction, SticksOrSlips) {
  Touched s(0.1);
  ASSERT_TRUE(s.touch(1, 0.3));
  const StripLaw law{0.3, 7, 0.5};  // the pressure is 1.4 N
  VectorXd inverse_mass(4);
  inverse_mass << 0, 0, 0, 2;
  const Vector3d along = s.normal().unitOrthogonal();
  VectorXd v = VectorXd::Zero(12);
  v.tail<3>() = along + 3 * s.normal();
  apply_strip_friction(std::span(&s.contact, 1), law, inverse_mass, 0.1, s.x, v);
  EXPECT_LE((v.tail<3>() - (1 - 0.5 * 1.4 * 0.1 * 2) * along - 3 * s.normal()).norm(), 100 * kRounding)
      << "slips";
  apply_strip_friction(std::span(&s.contact, 1), law, inverse_mass, 10, s.x, v);
  EXPECT_LE((v.tail<3>() - 3 * s.normal()).norm(), 100 * kRounding) << "sticks";
  const VectorXd still = v = VectorXd::Zero(12);
  apply_strip_friction(std::span(&s.contact, 1), law, inverse_mass, 10, s.x, v);
  EXPECT_EQ(v, still);
  v.setOnes();
  v.tail<3>() = along;
  const VectorXd held = v;
  apply_strip_friction(std::span(&s.contact, 1), law, VectorXd::Zero(4), 10, s.x, v);
  EXPECT_EQ(v, held) << "all pinned";
}

TEST(StaticLinks, AllocateNothing) {
  const Linked linked;
  const Pressed pressed;
  Touched touched(0.1);
  VectorXd f = VectorXd::Zero(21), largest = linked.largest;
  const VectorXd inverse_mass = VectorXd::Ones(7);
  const long before = allocations();
  remember_stretches(linked.links, linked.frames, linked.x, largest);
  double energy = link_energy(linked.links, linked.frames, linked.largest, linked.x);
  add_link_force(linked.links, linked.frames, linked.largest, linked.x, f);
  add_link_product(linked.links, linked.largest, linked.x, f);
  EXPECT_TRUE(touched.touch(1, 0.3));
  energy += strip_energy(pressed.contacts, pressed.law, pressed.x);
  add_strip_force(pressed.contacts, pressed.law, pressed.x, f);
  add_strip_product(pressed.contacts, pressed.law, pressed.x, pressed.x, f);
  apply_strip_friction(pressed.contacts, pressed.law, inverse_mass, 0.1, pressed.x, f);
  EXPECT_EQ(allocations(), before) << energy;
}

}  // namespace
}  // namespace reference_tests

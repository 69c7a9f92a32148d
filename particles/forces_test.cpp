// Gravity, drag, springs, their sum, and a system of particles: their properties.

#include <gtest/gtest.h>

#include "handout/check/derivative.h"
#include "particles/drag.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/springs.h"
#include "particles/system.h"
#include "solver/dense_algebra.h"

namespace particles_tests {
namespace {

using checks::scattered_vector;
using Eigen::Vector3d;
using Eigen::VectorXd;
using particles::DampedSprings;
using particles::Drag;
using particles::Force;
using particles::ForceSum;
using particles::Gravity;
using particles::Products;
using particles::Spring;

using particles::Particles;
using particles::ParticleSystem;

constexpr int kCount = 5;
constexpr double kSize = 100;  // the largest stiffness, of which entries are made

VectorXd force_at(const Force& force, const VectorXd& x, const VectorXd& v) {
  VectorXd f = VectorXd::Zero(x.size());
  force.add_force(x, v, f);
  return f;
}

VectorXd dfdx_at(const Force& force, const VectorXd& x, const VectorXd& v, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  force.add_dfdx(x, v, dx, df);
  return df;
}

VectorXd dfdv_at(const Force& force, const VectorXd& x, const VectorXd& v, const VectorXd& dv) {
  VectorXd df = VectorXd::Zero(x.size());
  force.add_dfdv(x, v, dv, df);
  return df;
}

// The matrix df/dx, column by column from products.
Eigen::MatrixXd dfdx_matrix(const Force& force, const VectorXd& x, const VectorXd& v) {
  Eigen::MatrixXd K(x.size(), x.size());
  for (int i = 0; i < x.size(); ++i) K.col(i) = dfdx_at(force, x, v, VectorXd::Unit(x.size(), i));
  return K;
}

// v = 0, so that damping has no effect.
void expect_force_is_minus_gradient(const Force& force, const VectorXd& x) {
  checks::expect_force(
      force_at(force, x, VectorXd::Zero(x.size())), [&](const VectorXd& y) { return force.energy(y); }, x, 1,
      kSize);
}

void expect_products_are_derivatives(const Force& force, const VectorXd& x, const VectorXd& v) {
  for (int which = 1; which <= 3; ++which) {
    const VectorXd d = scattered_vector(static_cast<int>(x.size()), which);
    checks::expect_product(
        dfdx_at(force, x, v, d), [&](const VectorXd& y) { return force_at(force, y, v); }, x, d, 1, kSize);
    checks::expect_product(
        dfdv_at(force, x, v, d), [&](const VectorXd& w) { return force_at(force, x, w); }, v, d, 1, kSize);
  }
}

void expect_near(const VectorXd& actual, const VectorXd& expected) {
  EXPECT_LE((actual - expected).norm(), 1e-12 * expected.norm()) << "sums of a few terms";
}

// All pairs of five particles that lie about 1 apart, some springs stretched, some compressed; stiffnesses,
// dampings and rest lengths differ.
std::vector<Spring> net() {
  std::vector<Spring> springs;
  for (int i = 0; i < kCount; ++i)
    for (int j = 0; j < i; ++j) springs.push_back({i, j, 10.0 + i + 3 * j, 0.2 + 0.2 * i, 0.3 + 0.1 * j});
  return springs;
}

std::vector<Spring> undamped(std::vector<Spring> springs) {
  for (Spring& spring : springs) spring.damping = 0;
  return springs;
}

const VectorXd kPlaces = scattered_vector(3 * kCount, 11), kVelocities = scattered_vector(3 * kCount, 12);
const VectorXd kMasses = (VectorXd(kCount) << 0.3, 2, 0.7, 5, 0.11).finished();

TEST(Gravity, IsMassTimesAcceleration) {
  const Gravity gravity(kMasses, {0.5, -1, -9.81});
  const VectorXd f = force_at(gravity, kPlaces, kVelocities);
  for (int i = 0; i < kCount; ++i)
    EXPECT_EQ(f.segment<3>(3 * i), Vector3d(kMasses[i] * Vector3d(0.5, -1, -9.81)));
  expect_force_is_minus_gradient(gravity, kPlaces);
  expect_products_are_derivatives(gravity, kPlaces, kVelocities);
}

TEST(Drag, SlowsDownAgainstTheWind) {
  const Drag drag(kMasses, {1, 2, 3});  // a coefficient per particle
  const VectorXd f = force_at(drag, kPlaces, kVelocities);
  for (int i = 0; i < kCount; ++i)
    EXPECT_LE((f.segment<3>(3 * i) + kMasses[i] * (kVelocities.segment<3>(3 * i) - Vector3d(1, 2, 3))).norm(),
              1e-15 * f.norm());
  expect_products_are_derivatives(drag, kPlaces, kVelocities);
  EXPECT_EQ(drag.energy(kPlaces), 0);
  EXPECT_EQ(force_at(Drag(VectorXd::Constant(1, 4)), VectorXd::Zero(3), Vector3d(1, -2, 0.5)),
            VectorXd(Vector3d(-4, 8, -2)));
  EXPECT_THROW(Drag(VectorXd::Constant(2, -1)), std::invalid_argument);
  EXPECT_THROW(Drag(VectorXd::Constant(2, NAN)), std::invalid_argument);
}

TEST(DampedSprings, ForceAndProductsAreDerivatives) {
  const DampedSprings springs(net());
  expect_force_is_minus_gradient(springs, kPlaces);
  expect_products_are_derivatives(springs, kPlaces, kVelocities);
}

TEST(DampedSprings, PullTogetherWhenStretchedAndPushWhenCompressed) {
  const VectorXd x = (VectorXd(6) << 0, 0, 0, 2, 0, 0).finished(), rest = VectorXd::Zero(6);
  EXPECT_EQ(force_at(DampedSprings({{0, 1, 10, 1.5}}), x, rest)[0], 5);
  EXPECT_EQ(force_at(DampedSprings({{0, 1, 10, 2.5}}), x, rest)[0], -5);
  EXPECT_EQ(DampedSprings({{0, 1, 10, 1.5}}).energy(x), 1.25);
  // Damping acts along the spring alone: 3 m/s apart, and 7 m/s across.
  const VectorXd apart = (VectorXd(6) << 0, 0, 0, 3, 7, 0).finished();
  EXPECT_EQ(force_at(DampedSprings({{0, 1, 0, 1, 2}}), x, apart),
            (VectorXd(6) << 6, 0, 0, -6, 0, 0).finished());
}

TEST(DampedSprings, DontMindRigidMotion) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -2) / 3).toRotationMatrix();
  const Vector3d spin(0.4, -1, 0.2);
  VectorXd x(3 * kCount), v(3 * kCount);
  for (int i = 0; i < kCount; ++i) {
    x.segment<3>(3 * i) = R * kPlaces.segment<3>(3 * i) + Vector3d(3, -1, 2);
    // A rotation of the whole and a common velocity change no length.
    v.segment<3>(3 * i) = R * kVelocities.segment<3>(3 * i) + spin.cross(Vector3d(x.segment<3>(3 * i)));
  }
  const DampedSprings springs(net());
  const VectorXd before = force_at(springs, kPlaces, kVelocities), after = force_at(springs, x, v);
  EXPECT_NEAR(springs.energy(x), springs.energy(kPlaces), 1e-13 * springs.energy(x));
  for (int i = 0; i < kCount; ++i)
    EXPECT_LE((after.segment<3>(3 * i) - R * before.segment<3>(3 * i)).norm(), 1e-13 * before.norm());
}

TEST(DampedSprings, DefiniteProductsAreSymmetricAndNeverPositive) {
  std::vector<Spring> some_pressed = net();
  for (Spring& spring : some_pressed) spring.rest_length *= 3;
  const DampedSprings springs(some_pressed, Products::definite);
  const Eigen::MatrixXd K = dfdx_matrix(springs, kPlaces, kVelocities);
  EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm());
  EXPECT_LE(solver::symmetric_eigenvalues(K).maxCoeff(), 1e-14 * K.norm());
  // The exact ones are not symmetric with damping, and not definite in compression.
  const Eigen::MatrixXd exact = dfdx_matrix(DampedSprings(net()), kPlaces, kVelocities);
  EXPECT_GT((exact - exact.transpose()).norm(), 1e-3 * exact.norm());
  const Eigen::MatrixXd pressed = dfdx_matrix(DampedSprings({{0, 1, 10, 5}}), kPlaces, kVelocities);
  EXPECT_GT(solver::symmetric_eigenvalues(pressed).maxCoeff(), 1);
}

TEST(DampedSprings, DefiniteProductsAreExactInTension) {
  std::vector<Spring> springs = undamped(net());
  for (Spring& spring : springs) spring.rest_length = 0.01;
  EXPECT_EQ(dfdx_matrix(DampedSprings(springs, Products::definite), kPlaces, kVelocities),
            dfdx_matrix(DampedSprings(springs), kPlaces, kVelocities));
}

TEST(DampedSprings, OfLengthZeroDoNothing) {
  const DampedSprings springs({{0, 1, 10, 0.5, 1}});
  const VectorXd x = VectorXd::Constant(6, 0.25), v = scattered_vector(6, 3);
  EXPECT_EQ(force_at(springs, x, v), VectorXd::Zero(6));
  EXPECT_EQ(dfdx_at(springs, x, v, v), VectorXd::Zero(6));
  EXPECT_EQ(dfdv_at(springs, x, v, v), VectorXd::Zero(6));
}

TEST(DampedSprings, RefuseBadValues) {
  for (const Spring& bad : {Spring{0, 0, 1, 1}, Spring{-1, 0, 1, 1}, Spring{0, -1, 1, 1}, Spring{0, 1, -1, 1},
                            Spring{0, 1, 1, -1}, Spring{0, 1, 1, 1, -1}, Spring{0, 1, NAN, 1}})
    EXPECT_THROW(DampedSprings({bad}), std::invalid_argument);
}

TEST(ForceSum, AddsItsPartsUp) {
  ForceSum sum;
  EXPECT_EQ(force_at(sum, kPlaces, kVelocities), VectorXd::Zero(3 * kCount));
  EXPECT_EQ(sum.energy(kPlaces), 0);

  const Gravity gravity(kMasses, {0, 0, -9.81});
  const Drag drag(kMasses);
  const DampedSprings springs(net());
  sum.emplace<Gravity>(kMasses, Vector3d(0, 0, -9.81));
  sum.emplace<Drag>(kMasses);
  sum.add(std::make_unique<DampedSprings>(net()));
  expect_near(force_at(sum, kPlaces, kVelocities), force_at(gravity, kPlaces, kVelocities) +
                                                       force_at(drag, kPlaces, kVelocities) +
                                                       force_at(springs, kPlaces, kVelocities));
  EXPECT_DOUBLE_EQ(sum.energy(kPlaces), gravity.energy(kPlaces) + springs.energy(kPlaces));
  expect_products_are_derivatives(sum, kPlaces, kVelocities);
}

TEST(Forces, AreAddedToWhatIsThere) {
  ForceSum sum;
  sum.emplace<Gravity>(kMasses, Vector3d(0, 0, -9.81));
  sum.emplace<Drag>(kMasses);
  sum.emplace<DampedSprings>(net());
  const VectorXd there = VectorXd::Constant(3 * kCount, 1000);
  VectorXd f = there, dx = there, dv = there;
  sum.add_force(kPlaces, kVelocities, f);
  sum.add_dfdx(kPlaces, kVelocities, kPlaces, dx);
  sum.add_dfdv(kPlaces, kVelocities, kPlaces, dv);
  expect_near(f - there, force_at(sum, kPlaces, kVelocities));
  expect_near(dx - there, dfdx_at(sum, kPlaces, kVelocities, kPlaces));
  expect_near(dv - there, dfdv_at(sum, kPlaces, kVelocities, kPlaces));
}

Particles three() {
  return {Vector3d(0.5, 2, 4), {0, 1, 0}};
}

TEST(ParticleSystem, AcceleratesByForceOverMassButNotThePinned) {
  particles::ForceSum force;
  force.emplace<particles::Gravity>(three().mass, Vector3d(0, 0, -9.81));
  force.emplace<particles::DampedSprings>(std::vector<particles::Spring>{{0, 1, 8, 1}, {1, 2, 8, 1}});
  const Particles particles = three();
  ParticleSystem system(particles, force);
  VectorXd x(9), a = VectorXd::Constant(9, NAN);
  x << 2, 0, 0, 0, 0, 0, 0, 3, 0;
  system.acceleration(x, VectorXd::Zero(9), a);
  // Springs pull by 8 and 16 N, masses are 0.5 and 4 kg.
  EXPECT_EQ(a, (VectorXd(9) << -16, 0, -9.81, 0, 0, 0, 0, -4, -9.81).finished());
}

TEST(ParticleSystem, RefusesWhatHasNoMass) {
  const particles::ForceSum none;
  for (double mass : {0.0, -1.0, double{NAN}}) {
    const Particles particles{Eigen::VectorXd::Constant(1, mass), {0}};
    EXPECT_THROW(ParticleSystem(particles, none), std::invalid_argument);
  }
  const Particles short_of_pinned{Eigen::VectorXd::Constant(2, 1), {0}};
  EXPECT_THROW(ParticleSystem(short_of_pinned, none), std::invalid_argument);
}

TEST(Momenta, AreSumsOverParticles) {
  VectorXd x(9), v(9);
  x << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  v << 0, 2, 0, 0, 0, 1, 3, 0, 0;
  EXPECT_EQ(particles::kinetic_energy(three(), v), 0.5 * (0.5 * 4 + 2 * 1 + 4 * 9));
  EXPECT_EQ(particles::momentum(three(), v), Vector3d(12, 1, 2));
  EXPECT_EQ(particles::angular_momentum(three(), x, v), Vector3d(2, 12, 1));
  // About another point p: L - p x P.
  const Vector3d p(1, -2, 0.5);
  EXPECT_LE(
      (particles::angular_momentum(three(), x, v, p) - (Vector3d(2, 12, 1) - p.cross(Vector3d(12, 1, 2))))
          .norm(),
      1e-14);
  EXPECT_EQ(particles::total_force(v), Vector3d(3, 2, 1));
  EXPECT_EQ(particles::total_torque(x, v), Vector3d(1, 3, 2));
}

}  // namespace
}  // namespace particles_tests

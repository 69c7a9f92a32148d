// Penalty contact with planes and spheres, by its properties.
#include "particles/contact.h"

#include <gtest/gtest.h>

#include "particles/tests/derivative.h"
#include "solver/symmetric_eigen.h"

namespace particles_tests {
namespace {

using particles::PlaneContact;
using particles::Products;
using particles::SphereContact;

const Vector3d kNormal(0.6, 0, 0.8), kPoint(0.1, 0.2, 0.3);

// Three particles: in contact, in contact by another depth, and outside of plane and sphere.
VectorXd places() {
  VectorXd x(9);
  x << kPoint - 0.3 * kNormal + Vector3d(0, 0.2, 0), kPoint - 0.5 * kNormal, kPoint + 2 * kNormal;
  return x;
}

// Slow enough that damping takes nothing away of the penalty.
VectorXd velocities() {
  return 0.1 * scattered(9, 21);
}

TEST(PlaneContact, PushesOutWhatIsBelow) {
  const PlaneContact plane(kPoint, 5 * kNormal, 100, 2);
  const VectorXd f = force_at(plane, places(), VectorXd::Zero(9));
  EXPECT_LE((f.segment<3>(0) - 30 * kNormal).norm(), 1e-13);
  EXPECT_LE((f.segment<3>(3) - 50 * kNormal).norm(), 1e-13);
  EXPECT_EQ(Vector3d(f.segment<3>(6)), Vector3d::Zero());
  EXPECT_NEAR(plane.energy(places()), 50 * (0.09 + 0.25), 1e-13);
}

TEST(PlaneContact, ForceAndProductsAreDerivatives) {
  const PlaneContact plane(kPoint, kNormal, 100, 2);
  expect_force_is_minus_gradient(plane, places());
  expect_products_are_derivatives(plane, places(), velocities());
  expect_symmetric_dfdx(plane, places(), velocities());
}

TEST(SphereContact, PushesOutWhatIsInside) {
  const SphereContact sphere(kPoint, 1, 100, 2);
  const VectorXd f = force_at(sphere, places(), VectorXd::Zero(9));
  EXPECT_LE((f.segment<3>(3) + 50 * kNormal).norm(), 1e-13);
  EXPECT_EQ(Vector3d(f.segment<3>(6)), Vector3d::Zero());
  EXPECT_EQ(force_at(sphere, kPoint, VectorXd::Zero(3)), VectorXd(Vector3d(0, 0, 100))) << "at the centre";
}

TEST(SphereContact, ForceAndProductsAreDerivatives) {
  for (double damping : {0.0, 2.0}) {
    const SphereContact sphere(kPoint, 1, 100, damping);
    expect_force_is_minus_gradient(sphere, places());
    expect_products_are_derivatives(sphere, places(), velocities());
  }
  expect_symmetric_dfdx(SphereContact(kPoint, 1, 100), places(), velocities());
}

TEST(SphereContact, DefiniteProductsAreSymmetricAndNeverPositive) {
  const Eigen::MatrixXd K =
      dfdx_matrix(SphereContact(kPoint, 1, 100, 2, Products::definite), places(), velocities());
  EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm());
  EXPECT_LE(solver::symmetric_eigenvalues(K).maxCoeff(), 1e-14 * K.norm());
  const Eigen::MatrixXd exact = dfdx_matrix(SphereContact(kPoint, 1, 100), places(), velocities());
  EXPECT_GT(solver::symmetric_eigenvalues(exact).maxCoeff(), 1);
}

TEST(Contact, DampsInContactAloneAndNeverPulls) {
  const PlaneContact plane(Vector3d::Zero(), Vector3d::UnitZ(), 100, 5);
  const SphereContact sphere(Vector3d(0, 0, -10), 10, 100, 5);
  const Vector3d inside(0, 0, -0.01), outside(0, 0, 0.01);  // the penalty pushes by 1 N inside
  for (const particles::Force* force : std::initializer_list<const particles::Force*>{&plane, &sphere}) {
    EXPECT_NEAR(force_at(*force, inside, Vector3d(0, 0, 0.1))[2], 0.5, 1e-12) << "leaves slowly";
    EXPECT_NEAR(force_at(*force, inside, Vector3d(0, 0, -2))[2], 11, 1e-12) << "enters";
    EXPECT_EQ(force_at(*force, inside, Vector3d(0, 0, 1)), VectorXd::Zero(3)) << "leaves fast";
    EXPECT_EQ(dfdx_at(*force, inside, Vector3d(0, 0, 1), inside), VectorXd::Zero(3));
    EXPECT_EQ(dfdv_at(*force, inside, Vector3d(0, 0, 1), inside), VectorXd::Zero(3));
    EXPECT_EQ(force_at(*force, outside, Vector3d(0, 0, -100)), VectorXd::Zero(3));
    EXPECT_NEAR(force_at(*force, inside, Vector3d(3, 4, 0)).head<2>().norm(), 0, 1e-12) << "no friction";
  }
}

TEST(Contact, TakesEnergyAwayByDampingOnly) {
  // f . v of the damping's part is never positive.
  const SphereContact with(kPoint, 1, 100, 2), without(kPoint, 1, 100);
  for (unsigned seed = 1; seed < 50; ++seed) {
    const VectorXd v = 20 * scattered(9, seed);
    EXPECT_LE((force_at(with, places(), v) - force_at(without, places(), v)).dot(v), 1e-12);
  }
}

TEST(Contact, RefusesBadValues) {
  EXPECT_THROW(PlaneContact(kPoint, Vector3d::Zero(), 1), std::invalid_argument);
  EXPECT_THROW(PlaneContact(kPoint, Vector3d(NAN, 0, 0), 1), std::invalid_argument);
  EXPECT_THROW(PlaneContact(kPoint, kNormal, -1), std::invalid_argument);
  EXPECT_THROW(PlaneContact(kPoint, kNormal, 1, -1), std::invalid_argument);
  EXPECT_THROW(SphereContact(kPoint, 0, 1), std::invalid_argument);
  EXPECT_THROW(SphereContact(kPoint, 1, NAN), std::invalid_argument);
}

}  // namespace
}  // namespace particles_tests

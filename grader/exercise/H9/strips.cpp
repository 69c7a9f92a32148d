// STAFF ONLY. H9's strips. Bounds: the contract's, 1e-12 of what results are made of. Shares are areas over that of a
// triangle whose height is 0.3 of its edge or more, with edges of 5 mm beside coordinates of 10 cm: 20 / 0.3 roundings, squared for
// two subtractions that each lose a digit: 1e-12.
#include <cmath>

#include "grader/exercise/H9/answers.h"
#include "grader/exercise/H9/cases.h"
#include "grader/suite/random_vector.h"

namespace grader::h9 {
namespace {

constexpr double kOfForces = 1e-12, kOfContacts = 1e-11;

double worst(const VectorXd& errors) {
  return errors.hasNaN() ? std::nan("") : errors.cwiseAbs().maxCoeff();
}

std::optional<StripContact> reference_touch(const NearTriangle& near, double side) {
  StripContact contact;
  if (!hair::touch_strip(3, {0, 1, 2}, side, near.thickness, near.x, near.tangents, contact)) return {};
  return contact;
}

Vector3d inside(Random& random) {
  Vector3d shares(random.uniform(0.05), random.uniform(0.05), random.uniform(0.05));
  return shares / shares.sum();
}

// One or two shares are negative.
Vector3d outside(Random& random, int j) {
  Vector3d shares = inside(random);
  shares[j % 3] = -random.uniform(0.05, 1);
  if (j % 2 == 1) shares[(j + 1) % 3] = -random.uniform(0.05, 1);
  shares[(j + 2) % 3] = 1 - shares[j % 3] - shares[(j + 1) % 3];
  return shares;
}

StripContact expect_touch(Trial& trial, const NearTriangle& near, double side) {
  const std::optional<StripContact> touched = ask_touch(trial, near, side);
  trial.require(touched.has_value(), "a point near a triangle is not seen");
  return *touched;
}

}  // namespace

void touches(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 12; ++repeat) {
    const double side = repeat % 2 == 0 ? 1 : -1, above = repeat % 4 < 2 ? 1 : -1;
    trial.describe("over the inside of a triangle");
    const NearTriangle near = near_triangle(random, inside(random), above * random.uniform(0.02, 0.95));
    const StripContact expected = *reference_touch(near, side), touched = expect_touch(trial, near, side);
    trial.expect(touched.point == 3 && touched.corners == expected.corners,
                 "a contact names other particles than it was asked about");
    trial.expect_at_most((touched.normal - expected.normal).norm(), kOfContacts, "the error of a normal");
    for (int j = 0; j < 3; ++j)
      trial.expect_at_most(std::abs(touched.shares[j] - expected.shares[j]), kOfContacts,
                           "the error of a share");
    trial.describe("beside a triangle");
    trial.expect(!ask_touch(trial, near_triangle(random, outside(random, repeat), 0.5), side),
                 "a point beside a triangle touches it");
    trial.describe("too far above a triangle, or below it");
    trial.expect(
        !ask_touch(trial, near_triangle(random, inside(random), above * random.uniform(1.05, 3)), side),
        "a point touches a triangle that is farther away than the thickness");
  }
  trial.describe("over an edge or a corner, without any rounding");
  for (const auto& [along, across] : {std::pair{0.0625, 0.0}, {0.0, 0.0625}, {0.0, 0.0}}) {
    NearTriangle edge = near_triangle(random, inside(random), 0.5);
    edge.thickness = 0.25;
    edge.x << 0, 0, 0, 0.25, 0, 0, 0, 0.25, 0, along, across, 0.125;
    expect_touch(trial, edge, 1);  // a share of 0 is not negative
    edge.x[11] = edge.thickness;
    trial.expect(!ask_touch(trial, edge, 1),
                 "a point touches a triangle that is as far away as the thickness");
  }
  trial.describe("a triangle without an area");
  NearTriangle flat = near_triangle(random, inside(random), 0.5);
  flat.x.segment<3>(3) = Vector3d(flat.x.head<3>());
  trial.expect(!ask_touch(trial, flat, 1), "a triangle without an area is touched");
  flat.x.segment<3>(6) = Vector3d(flat.x.head<3>());
  trial.expect(!ask_touch(trial, flat, 1), "a triangle without an area is touched");
}

void weights(Trial& trial) {
  Random& random = trial.random;
  const auto expect_weight = [&](const NearTriangle& near, const std::string& what) {
    trial.describe(what);
    const double weight = expect_touch(trial, near, 1).weight;
    trial.expect_at_most(std::abs(weight - reference_touch(near, 1)->weight), kOfContacts,
                         "the error of a weight");
    trial.expect(weight >= 0, "a weight is negative",
                 std::to_string(weight));  // by rounding alone, where hairs are parallel
  };
  for (int repeat = 0; repeat < 12; ++repeat) {
    NearTriangle near = near_triangle(random, inside(random), 0.5);
    const Vector3d one = some_direction(random), other = some_direction(random);
    for (int j = 0; j < 3; ++j) near.tangents.segment<3>(3 * j) = one;
    near.tangents.tail<3>() = repeat % 2 == 0 ? one : Vector3d(-one);
    expect_weight(near, "hairs that lie side by side");
    near.tangents.tail<3>() = other;
    expect_weight(near, "a strip whose hairs have one direction");
    near.tangents.segment<3>(3 * (repeat % 3)) = -one;
    expect_weight(near, "a strip, of whose hairs one runs back");
    for (int j = 0; j < 3; ++j) near.tangents.segment<3>(3 * j) = some_direction(random);
    expect_weight(near, "a strip whose hairs have different directions");
    near.tangents.segment<3>(3 * (repeat % 3)).setZero();
    expect_weight(near, "a strip, of whose hairs one has no direction");
    near.tangents.tail<3>().setZero();
    expect_weight(near, "a point whose hair has no direction");
  }
}

void strip_forces(Trial& trial) {
  for (const int count : {1, 2, 5, 20}) {
    const Contacts contacts = some_contacts(trial.random, count);
    const double size = contacts.size(),
                 energy = hair::strip_energy(contacts.contacts, contacts.law, contacts.x);
    trial.expect_at_most(std::abs(ask_strip_energy(trial, contacts) - energy),
                         kOfForces * size * (contacts.law.thickness + 4 * contacts.x.cwiseAbs().maxCoeff()),
                         "the error of an energy");
    const VectorXd before = random_vector(trial.random, contacts.x.size(), size / count);
    VectorXd expected = before;
    hair::add_strip_force(contacts.contacts, contacts.law, contacts.x, expected);
    trial.expect_at_most(worst(ask_strip_force(trial, contacts, before) - expected), kOfForces * 5 * size,
                         "the error of a force");
  }
}

void strip_products(Trial& trial) {
  for (const int count : {1, 2, 5, 20}) {
    const Contacts contacts = some_contacts(trial.random, count);
    const VectorXd dx = random_vector(trial.random, contacts.x.size(), 0.02),
                   before = random_vector(trial.random, contacts.x.size(), contacts.size() / count);
    VectorXd expected = before;
    hair::add_strip_product(contacts.contacts, contacts.law, contacts.x, dx, expected);
    trial.expect_at_most(worst(ask_strip_product(trial, contacts, dx, before) - expected),
                         kOfForces * 10 * contacts.size(), "the error of a product");
  }
}

// From steps so short that all slip to steps so long that all stick.
void frictions(Trial& trial) {
  Random& random = trial.random;
  for (const int count : {1, 2, 5, 20})
    for (const double h : {1e-5, 1e-3, 1e2}) {
      Contacts contacts = some_contacts(random, count);
      VectorXd v = random_vector(random, contacts.x.size(), 0.3), expected = v;
      hair::apply_strip_friction(contacts.contacts, contacts.law, contacts.inverse_mass, h, contacts.x,
                                 expected);
      // A mass is at most 100 times another, so that what one impulse rounds by moves another by 100 times as much.
      trial.expect_at_most(worst(ask_friction(trial, contacts, h, v) - expected), 1e-10,
                           "the error of a velocity");
      Contacts first_pinned = contacts;
      const StripContact& first = first_pinned.contacts.front();
      first_pinned.inverse_mass[first.point] = 0;
      for (const int corner : first.corners) first_pinned.inverse_mass[corner] = 0;
      v = expected = random_vector(random, contacts.x.size(), 0.3);
      hair::apply_strip_friction(first_pinned.contacts, contacts.law, first_pinned.inverse_mass, h,
                                 contacts.x, expected);
      trial.expect_at_most(worst(ask_friction(trial, first_pinned, h, v) - expected), 1e-10,
                           "the error of a velocity where the first contact is pinned");
      Contacts smooth = contacts;
      smooth.law.friction = 0;
      trial.expect_at_most(worst(ask_friction(trial, smooth, h, v) - v), 0, "a velocity where mu is 0");
      v.setZero();
      trial.expect_at_most(worst(ask_friction(trial, contacts, h, v)), 0, "a velocity where nothing moves");
      contacts.inverse_mass.setZero();
      // Points of 1 kg above pinned corners: W = 1.
      for (const StripContact& contact : contacts.contacts) contacts.inverse_mass[contact.point] = 1;
      v = expected = random_vector(random, contacts.x.size(), 0.3);
      hair::apply_strip_friction(contacts.contacts, contacts.law, contacts.inverse_mass, h, contacts.x,
                                 expected);
      trial.expect_at_most(worst(ask_friction(trial, contacts, h, v) - expected), 1e-10,
                           "the error of a velocity where corners are pinned");
      contacts.inverse_mass.setZero();
      v.setOnes();
      trial.expect_at_most(worst((ask_friction(trial, contacts, h, v).array() - 1).matrix()), 0,
                           "the change of a velocity where all is pinned");
    }
}

}  // namespace grader::h9

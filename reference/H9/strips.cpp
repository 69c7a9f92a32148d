// STAFF ONLY. Hidden cases of H9's strips. Bounds: the contract's, 1e-12 of a result's parts. Barycentric
// weights are areas over that of a triangle whose height is 0.3 of its edge or more, with edges of 5 mm and
// coordinates of 10 cm: 20 / 0.3 roundings, squared for two subtractions that each lose a digit: 1e-12.
#include <cmath>

#include "grader/judge/cases/random.h"
#include "handout/check/ordinary.h"
#include "reference/H9/answers.h"

namespace grader::h9 {
namespace {

constexpr double kOfForces = 1e-12, kOfContacts = 1e-11;

std::optional<StripContact> reference_touch(const NearTriangle& near, double side) {
  StripContact contact;
  if (!hair::touch_strip(3, {0, 1, 2}, side, near.thickness, near.x, near.tangents, contact)) return {};
  return contact;
}

Vector3d inside(Random& random) {
  Vector3d shares;
  for (double& share : shares) share = random.uniform(0.05);
  return shares / shares.sum();
}

// Barycentric weights of which one or two are negative.
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

void expect_weight(Trial& trial, const NearTriangle& near, const std::string& what) {
  trial.describe(what);
  const double weight = expect_touch(trial, near, 1).weight;
  trial.expect_near(compared(weight, reference_touch(near, 1)->weight), kOfContacts, "the error of a weight");
  trial.expect(weight >= 0, "a weight is negative",
               std::to_string(weight));  // by rounding alone, where hairs are parallel
}

VectorXd none(const Contacts& contacts) {
  return VectorXd::Zero(contacts.x.size());
}

VectorXd reference_friction(const Contacts& contacts, double h, VectorXd v) {
  hair::apply_strip_friction(contacts.contacts, contacts.law, contacts.inverse_mass, h, contacts.x, v);
  return v;
}

// From steps so short that all slip to steps so long that all stick.
constexpr std::array<double, 3> kSteps = {1e-5, 1e-3, 1e2};
// A mass is at most 100 times another, so an impulse's rounding moves a lighter particle by 100 times as
// much.
constexpr double kOfVelocities = 1e-10;

}  // namespace

void touches(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 12; ++repeat) {
    const double side = repeat % 2 == 0 ? 1 : -1, above = repeat % 4 < 2 ? 1 : -1;
    trial.describe("over the inside of a triangle");
    const Vector3d shares_inside = inside(random);
    const NearTriangle near = near_triangle(random, shares_inside, above * random.uniform(0.02, 0.95));
    const StripContact expected = *reference_touch(near, side), touched = expect_touch(trial, near, side);
    trial.expect(touched.point == 3 && touched.corners == expected.corners,
                 "a contact names other particles than it was asked about");
    trial.expect_at_most((touched.normal - expected.normal).norm(), kOfContacts, "the error of a normal",
                         {touched.normal, expected.normal});
    const auto shares = [](const StripContact& contact) {
      return Vector3d(contact.shares[0], contact.shares[1], contact.shares[2]);
    };
    trial.expect_near({shares(touched), shares(expected), 1}, kOfContacts, "the error of a share");
    trial.describe("beside a triangle");
    trial.expect(!ask_touch(trial, near_triangle(random, outside(random, repeat), 0.5), side),
                 "a point beside a triangle touches it");
    trial.describe("too far above a triangle, or below it");
    const Vector3d over = inside(random);
    trial.expect(!ask_touch(trial, near_triangle(random, over, above * random.uniform(1.05, 3)), side),
                 "a point touches a triangle that is farther away than the thickness");
  }
}

void flat_triangles(Trial& trial) {
  Random& random = trial.random;
  trial.describe("over an edge or a corner, without any rounding");
  for (const auto& [along, across] : {std::pair{0.0625, 0.0}, {0.0, 0.0625}, {0.0, 0.0}}) {
    NearTriangle edge = near_triangle(random, inside(random), 0.5);
    edge.thickness = 0.25;
    edge.x << 0, 0, 0, 0.25, 0, 0, 0, 0.25, 0, along, across, 0.125;
    expect_touch(trial, edge, 1);  // a weight of 0 is not negative
    edge.x[11] = edge.thickness;
    trial.expect(!ask_touch(trial, edge, 1),
                 "a point touches a triangle that is as far away as the thickness");
  }
  trial.describe("a triangle as thin as a needle, without any rounding");
  NearTriangle thin = near_triangle(random, inside(random), 0.5);
  thin.thickness = 0.25;
  thin.x << 0, 0, 0, 0.25, 0, 0, 0, 0x1p-40, 0, 0.0625, 0x1p-42, 0.125;
  expect_touch(trial, thin, 1);
  trial.describe("a triangle without an area");
  NearTriangle flat = near_triangle(random, inside(random), 0.5);
  flat.x.segment<3>(3) = Vector3d(flat.x.head<3>());
  trial.expect(!ask_touch(trial, flat, 1), "a triangle without an area is touched");
  flat.x.segment<3>(6) = Vector3d(flat.x.head<3>());
  trial.expect(!ask_touch(trial, flat, 1), "a triangle without an area is touched");
}

void weights(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 12; ++repeat) {
    NearTriangle near = near_triangle(random, inside(random), 0.5);
    const Vector3d one = some_direction(random), other = some_direction(random);
    for (int j = 0; j < 3; ++j) near.tangents.segment<3>(3 * j) = one;
    near.tangents.tail<3>() = repeat % 2 == 0 ? one : Vector3d(-one);
    expect_weight(trial, near, "hairs that lie side by side");
    near.tangents.tail<3>() = other;
    expect_weight(trial, near, "a strip whose hairs have one direction");
    near.tangents.segment<3>(3 * (repeat % 3)) = -one;
    expect_weight(trial, near, "a strip, of whose hairs one runs back");
    for (int j = 0; j < 3; ++j) near.tangents.segment<3>(3 * j) = some_direction(random);
    expect_weight(trial, near, "a strip whose hairs have different directions");
  }
}

// A hair without a direction counts as one that crosses: it is compared with the student's own weight for
// that.
void no_directions(Trial& trial) {
  Random& random = trial.random;
  const auto expect_same = [&](const NearTriangle& none, const NearTriangle& across,
                               const std::string& what) {
    trial.describe(what);
    const double weight = expect_touch(trial, none, 1).weight;
    trial.expect_at_most(std::abs(weight - expect_touch(trial, across, 1).weight), kOfContacts,
                         "the error of a weight of " + what);
    return weight;
  };
  for (int repeat = 0; repeat < 6; ++repeat) {
    NearTriangle near = near_triangle(random, inside(random), 0.5);
    const Vector3d e = some_direction(random);
    for (int j = 0; j < 3; ++j)
      near.tangents.segment<3>(3 * j) = e.cross(some_direction(random)).normalized();
    NearTriangle none = near;
    near.tangents.tail<3>() = e;
    expect_same(none, near, "a point whose hair has no direction");
    none.tangents.tail<3>() = near.tangents.tail<3>() = some_direction(random);
    const Vector3d point = near.tangents.tail<3>();
    none.tangents.segment<3>(3 * (repeat % 3)).setZero();
    near.tangents.segment<3>(3 * (repeat % 3)) = point.cross(e).normalized();
    trial.expect(expect_same(none, near, "a strip, of whose hairs one has no direction") > 0,
                 "a weight of hairs that cross is 0");
  }
}

void strip_forces(Trial& trial) {
  for (const int count : {1, 2, 5, 20}) {
    const Contacts contacts = some_contacts(trial.random, count);
    const double size = contacts.size(),
                 energy = hair::strip_energy(contacts.contacts, contacts.law, contacts.x);
    trial.expect_near(compared(ask_strip_energy(trial, contacts), energy),
                      kOfForces * size * (contacts.law.thickness + 4 * contacts.x.cwiseAbs().maxCoeff()),
                      "the error of an energy");
    VectorXd expected = none(contacts);
    hair::add_strip_force(contacts.contacts, contacts.law, contacts.x, expected);
    trial.expect_near({ask_strip_force(trial, contacts, none(contacts)), expected}, kOfForces * 5 * size,
                      "the error of a force");
  }
}

void strip_products(Trial& trial) {
  for (const int count : {1, 2, 5, 20}) {
    const Contacts contacts = some_contacts(trial.random, count);
    const VectorXd dx = random_vector(trial.random, contacts.x.size(), 0.02);
    VectorXd expected = none(contacts);
    hair::add_strip_product(contacts.contacts, contacts.law, contacts.x, dx, expected);
    trial.expect_near({ask_strip_product(trial, contacts, dx, none(contacts)), expected, 3, dx},
                      kOfForces * 10 * contacts.size(), "the error of a product");
  }
}

// One contact presses; the second one does not.
void frictions(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 3; ++repeat)
    for (const int count : {1, 2})
      for (const double h : kSteps) {
        Contacts contacts = some_contacts(random, count);
        const VectorXd v = random_vector(random, contacts.x.size(), 0.3);
        trial.expect_near({ask_friction(trial, contacts, h, v), reference_friction(contacts, h, v), 3, v},
                          kOfVelocities, "the error of a velocity");
        contacts.inverse_mass.setZero();
        for (const StripContact& contact : contacts.contacts) {
          const double inverse = checks::ordinary_number(random, 0.4, 3);
          contacts.inverse_mass[contact.point] = repeat == 0 ? 1 : inverse;  // 1 is a mass like others
        }
        trial.expect_near({ask_friction(trial, contacts, h, v), reference_friction(contacts, h, v), 3, v},
                          kOfVelocities, "the error of a velocity where corners are pinned");
      }
}

void pinned_frictions(Trial& trial) {
  Random& random = trial.random;
  for (const double h : kSteps) {
    Contacts contacts = some_contacts(random, 2);
    VectorXd v = random_vector(random, contacts.x.size(), 0.3);
    Contacts smooth = contacts;
    smooth.law.friction = 0;
    trial.expect_near({ask_friction(trial, smooth, h, v), v}, 0, "a velocity where mu is 0");
    trial.expect_near({ask_friction(trial, contacts, h, none(contacts)), none(contacts)}, 0,
                      "a velocity where nothing moves");
    contacts.inverse_mass.setZero();
    trial.expect_near({ask_friction(trial, contacts, h, v), v}, 0,
                      "the change of a velocity where all is pinned");
    const Contacts one = some_contacts(random, 1);
    const VectorXd moved = ask_friction(trial, one, h, random_vector(random, 21, 0.3));
    trial.expect(!moved.isZero(), "after friction all velocities are 0");
  }
}

// Compares with the student's own function, called for one contact after the other. Only the first contact
// may be pinned.
void friction_order(Trial& trial) {
  Random& random = trial.random;
  for (const int count : {5, 20})
    for (const double h : kSteps) {
      Contacts contacts = some_contacts(random, count);
      if (h == kSteps[1]) {
        const StripContact& first = contacts.contacts.front();
        contacts.inverse_mass[first.point] = 0;
        for (const int corner : first.corners) contacts.inverse_mass[corner] = 0;
      }
      const VectorXd start = random_vector(random, contacts.x.size(), 0.3);
      VectorXd one_by_one = start;
      for (const StripContact& contact : contacts.contacts) {
        Contacts one = contacts;
        one.contacts = {contact};
        one_by_one = ask_friction(trial, one, h, one_by_one);
      }
      trial.expect(one_by_one != start, "friction changes no velocity");
      trial.expect_near({ask_friction(trial, contacts, h, start), one_by_one, 3, start}, kOfVelocities,
                        "a velocity, beside that of one contact after the other");
    }
}

}  // namespace grader::h9

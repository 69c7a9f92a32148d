// STAFF ONLY. Hidden cases of H9 that compare a student's answers with each other: outputs that are added to,
// and other units.
//
// Bounds: those of each function's own cases. Powers of 2 change no digit, so units alone make no error.
#include <cmath>

#include "grader/judge/cases/random.h"
#include "reference/H9/answers.h"

namespace grader::h9 {
namespace {

constexpr double kOfAnswers = 1e-12;

// Compares two answers, and fails for 0, since 0 is the same in all units. Braces ask in their
// order, whichever compiler made the suite.
void expect_same(Trial& trial, const Compared& both, const std::string& what) {
  const double size = both.actual.norm();
  trial.expect(size > 0, what + " is 0");
  trial.expect_close(both, kOfAnswers * size, what);
}

VectorXd one_number(double value) {
  return VectorXd::Constant(1, value);
}

void expect_links_in(Trial& trial, const Units& units) {
  LinkedHairs hairs = some_linked_hairs(trial.random, 5, Frames::turned, Wear::some, Pull::little);
  const VectorXd dx = random_vector(trial.random, hairs.x.size(), 0.02), none = VectorXd::Zero(dx.size());
  const LinkedHairs other = in_units(hairs, units);
  const double force = units.mass * units.length;
  expect_same(trial,
              {one_number(ask_link_energy(trial, hairs)),
               one_number(ask_link_energy(trial, other) / (force * units.length))},
              "the energy of links in other units");
  expect_same(trial, {ask_link_force(trial, hairs, none), ask_link_force(trial, other, none) / force},
              "the force of links in other units");
  expect_same(trial,
              {ask_link_product(trial, hairs, dx, none),
               ask_link_product(trial, other, units.length * dx, none) / force},
              "the product of links in other units");
  expect_same(trial, {ask_stretches(trial, hairs), ask_stretches(trial, other)},
              "the stretches of links in other units");
}

void expect_touch_in(Trial& trial, const Units& units) {
  NearTriangle near = near_triangle(trial.random, Vector3d(0.5, 0.2, 0.3), 0.5);
  for (int j = 0; j < 4; ++j) near.tangents.segment<3>(3 * j) = some_direction(trial.random);
  const auto touched = ask_touch(trial, near, 1), other = ask_touch(trial, in_units(near, units), 1);
  trial.expect(touched.has_value() == other.has_value(), "touched in one unit of length and not in another");
  if (!touched.has_value() || !other.has_value()) return;
  VectorXd one(7), same(7);
  one << touched->normal, touched->shares[0], touched->shares[1], touched->shares[2], touched->weight;
  same << other->normal, other->shares[0], other->shares[1], other->shares[2], other->weight;
  expect_same(trial, {one, same}, "a contact in other units");
}

void expect_strips_in(Trial& trial, const Units& units) {
  const Contacts contacts = some_contacts(trial.random, 3), other = in_units(contacts, units);
  const VectorXd dx = random_vector(trial.random, contacts.x.size(), 0.02), none = VectorXd::Zero(dx.size()),
                 v = random_vector(trial.random, contacts.x.size(), 0.3);
  const double force = units.mass * units.length;
  expect_same(trial,
              {one_number(ask_strip_energy(trial, contacts)),
               one_number(ask_strip_energy(trial, other) / (force * units.length))},
              "the energy of strips in other units");
  expect_same(trial, {ask_strip_force(trial, contacts, none), ask_strip_force(trial, other, none) / force},
              "the force of strips in other units");
  expect_same(trial,
              {ask_strip_product(trial, contacts, dx, none),
               ask_strip_product(trial, other, units.length * dx, none) / force},
              "the product of strips in other units");
  for (const double h : {1e-4, 1e2})
    expect_same(trial,
                {ask_friction(trial, contacts, h, v) - v,
                 ask_friction(trial, other, h, units.length * v) / units.length - v},
                "what friction changes in other units");
}

}  // namespace

void added(Trial& trial) {
  Random& random = trial.random;
  const LinkedHairs hairs = some_linked_hairs(random, 7, Frames::straight, Wear::none, Pull::little);
  const Contacts contacts = some_contacts(random, 5);
  const auto expect_sum = [&](Eigen::Index entries, double size, const std::string& what, const auto& ask) {
    const VectorXd before = random_vector(random, entries, size), none = VectorXd::Zero(entries);
    const VectorXd alone = ask(none);
    trial.expect(alone.norm() > 0, what + " is 0");
    trial.expect_close({ask(before) - before, alone}, kOfAnswers * (before.norm() + 10 * size + alone.norm()),
                       what + ", added to what is there");
  };
  const VectorXd dx = random_vector(random, hairs.x.size(), 0.02),
                 dy = random_vector(random, contacts.x.size(), 0.02);
  expect_sum(hairs.x.size(), hairs.size(), "the force of links",
             [&](const VectorXd& f) { return ask_link_force(trial, hairs, f); });
  expect_sum(hairs.x.size(), hairs.size(), "the product of links",
             [&](const VectorXd& df) { return ask_link_product(trial, hairs, dx, df); });
  expect_sum(contacts.x.size(), contacts.size(), "the force of strips",
             [&](const VectorXd& f) { return ask_strip_force(trial, contacts, f); });
  expect_sum(contacts.x.size(), contacts.size(), "the product of strips",
             [&](const VectorXd& df) { return ask_strip_product(trial, contacts, dy, df); });
}

// Hair may have any thickness and weight, so no threshold in kg, m, N or m/s may show.
void other_units(Trial& trial) {
  for (const Units& units : {Units{.mass = 0x1p-60}, Units{.length = 0x1p-60}, Units{0x1p60, 0x1p40}}) {
    expect_links_in(trial, units);
    expect_touch_in(trial, units);
    expect_strips_in(trial, units);
  }
}

}  // namespace grader::h9

// STAFF ONLY. Hidden cases of H9's links. Bounds: the contract's, 1e-12 of the sum of a result's parts. A
// hundred links with a dozen roundings each make 1e-13.
#include <algorithm>
#include <cmath>

#include "grader/judge/cases/random.h"
#include "handout/check/ordinary.h"
#include "reference/H9/answers.h"

namespace grader::h9 {
namespace {

constexpr double kPart = 1e-12;

void expect_stretches(Trial& trial, const LinkedHairs& hairs) {
  VectorXd expected = hairs.largest;
  hair::remember_stretches(hairs.links, hairs.frames, hairs.x, expected);
  const VectorXd answered = ask_stretches(trial, hairs);
  double size = 1;  // lengths are at least 1.5 mm, so a stretch rounds by more than u of itself
  for (const StaticLink& link : hairs.links)
    size = std::max(size, (2 * hairs.x.cwiseAbs().maxCoeff() + link.offset.norm()) / link.length);
  trial.expect_near({answered, expected, 1, hairs.largest}, kPart * size, "the error of a largest stretch");
}

void expect_link_energy(Trial& trial, const LinkedHairs& hairs) {
  const double expected = hair::link_energy(hairs.links, hairs.frames, hairs.largest, hairs.x);
  const double size = hairs.size() * 3 * hairs.x.cwiseAbs().maxCoeff();
  trial.expect_near(compared(ask_link_energy(trial, hairs), expected), kPart * size,
                    "the error of an energy");
}

VectorXd none(const LinkedHairs& hairs) {
  return VectorXd::Zero(hairs.x.size());
}

void expect_link_force(Trial& trial, const LinkedHairs& hairs) {
  VectorXd expected = none(hairs);
  hair::add_link_force(hairs.links, hairs.frames, hairs.largest, hairs.x, expected);
  trial.expect_near({ask_link_force(trial, hairs, none(hairs)), expected}, kPart * hairs.size(),
                    "the error of a force");
}

VectorXd some_motion(Random& random, const LinkedHairs& hairs) {
  return random_vector(random, hairs.x.size(), hairs.x.cwiseAbs().maxCoeff() / 3);
}

void expect_link_product(Trial& trial, const LinkedHairs& hairs) {
  const VectorXd dx = some_motion(trial.random, hairs);
  VectorXd expected = none(hairs);
  hair::add_link_product(hairs.links, hairs.largest, dx, expected);
  trial.expect_near({ask_link_product(trial, hairs, dx, none(hairs)), expected, 3, dx},
                    kPart * 10 * hairs.size(), "the error of a product");
}

// Compares two answers about the same links in different forms. An answer of 0 fails.
void expect_same(Trial& trial, const LinkedHairs& one, const LinkedHairs& other, const std::string& what) {
  const double energy = ask_link_energy(trial, one), size = one.size();
  trial.expect(energy > 0, "the energy of links" + what + " is 0");
  trial.expect_at_most(std::abs(energy - ask_link_energy(trial, other)),
                       kPart * size * 3 * one.x.cwiseAbs().maxCoeff(), "the energy of links" + what);
  const VectorXd force = ask_link_force(trial, one, none(one));
  trial.expect(force.norm() > 0, "the force of links" + what + " is 0");
  trial.expect_near({force, ask_link_force(trial, other, none(one))}, kPart * size,
                    "a force of links" + what);
}

}  // namespace

void strengths(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 8; ++repeat) {
    StaticLink link;
    link.length = checks::ordinary_number(random, 0.3, 3);
    link.stiffness = checks::ordinary_number(random, 0.3, 3, link.length);
    link.yields = repeat == 0 ? 0 : random.uniform(0.1, 1);
    link.breaks = repeat < 3 ? link.yields : link.yields + random.uniform(0.1, 2);
    const double width = link.breaks - link.yields;
    for (const double largest : {0.0, link.yields * random.uniform(), link.yields, link.breaks,
                                 link.breaks + 0.01, link.breaks * random.uniform(1.1, 30) + 1})
      trial.expect_at_most(std::abs(ask_strength(trial, link, largest) - hair::link_strength(link, largest)),
                           0, "the error of a strength of 0 or 1");
    if (width == 0) continue;
    for (const double part : {0.01, random.uniform(), 0.99}) {
      const double largest = link.yields + part * width;
      trial.expect_at_most(std::abs(ask_strength(trial, link, largest) - hair::link_strength(link, largest)),
                           kPart, "the error of a strength between 0 and 1");
    }
  }
}

// Links are pulled, let go, and pulled again.
void histories(Trial& trial) {
  Random& random = trial.random;
  LinkedHairs hairs = some_linked_hairs(random, 6, Frames::straight, Wear::none, Pull::any);
  hairs.largest.setZero();
  for (const double scale : {0.2, 1.0, 0.1, 0.5, 2.0, 1.0, 0.01, 3.0}) {
    hairs.x = random_vector(random, hairs.x.size(), 0.05 * scale);
    expect_stretches(trial, hairs);
    hair::remember_stretches(hairs.links, hairs.frames, hairs.x, hairs.largest);
  }
}

void link_energies(Trial& trial) {
  for (const int links : {1, 2, 7, 40})
    expect_link_energy(trial,
                       some_linked_hairs(trial.random, links, Frames::straight, Wear::none, Pull::little));
}

void link_forces(Trial& trial) {
  for (const int links : {1, 2, 7, 40})
    expect_link_force(trial,
                      some_linked_hairs(trial.random, links, Frames::straight, Wear::none, Pull::little));
}

// Compares links in turned frames with links whose offsets are turned instead.
void turned_frames(Trial& trial) {
  for (const int links : {1, 2, 7, 40}) {
    LinkedHairs turned = some_linked_hairs(trial.random, links, Frames::turned, Wear::none, Pull::little);
    LinkedHairs straight = turned;
    for (StaticLink& link : straight.links) link.offset = turned.frames[link.a] * link.offset;
    for (Matrix3d& frame : straight.frames) frame.setIdentity();
    expect_same(trial, turned, straight, " in frames that turn");
    turned.largest.setZero();
    straight.largest.setZero();
    double size = 1;
    for (const StaticLink& link : turned.links)
      size = std::max(size, (2 * turned.x.cwiseAbs().maxCoeff() + link.offset.norm()) / link.length);
    const VectorXd stretches = ask_stretches(trial, turned);
    trial.expect_near({stretches, ask_stretches(trial, straight), 1}, kPart * size,
                      "the stretch of a link in frames that turn");
  }
}

// Compares worn links with new ones that have the stiffness by the student's own strength. The current
// stretch wears no link.
void worn_links(Trial& trial) {
  for (const int links : {3, 7, 40}) {
    const LinkedHairs worn = some_linked_hairs(trial.random, links, Frames::straight, Wear::some, Pull::any);
    LinkedHairs fresh = worn;
    fresh.largest.setZero();
    for (int l = 0; l < links; ++l)
      fresh.links[l].stiffness *= ask_strength(trial, worn.links[l], worn.largest[l]);
    expect_same(trial, worn, fresh, " that are worn or broken");
    const VectorXd dx = some_motion(trial.random, worn);
    trial.expect_near(
        {ask_link_product(trial, worn, dx, none(worn)), ask_link_product(trial, fresh, dx, none(worn))},
        kPart * 10 * worn.size(), "a product of links that are worn or broken");
  }
}

void link_products(Trial& trial) {
  for (const int links : {1, 2, 7, 40})
    expect_link_product(trial,
                        some_linked_hairs(trial.random, links, Frames::turned, Wear::none, Pull::little));
}

// The cases below compare a student's answers with each other: outputs that are added to, and other units.
// Powers of 2 change no digit, so units alone make no error.

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

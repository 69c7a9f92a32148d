// The public checks of H9, function by function. Lengths, stiffnesses and masses are about 1, so bounds of
// 1e-12 are thousands of roundings. The contract is in hair/static_links.h.

#include "hair/static_links.h"

#include <gtest/gtest.h>

#include <cmath>

#include "check.h"
#include "derivative.h"
#include "ordinary.h"

using namespace checks;
using Eigen::VectorXd;
using hair::Matrix3d, hair::StaticLink, hair::StripContact, hair::StripLaw, hair::Vector3d;

namespace {

VectorXd zeros(int particles) {
  return VectorXd::Zero(3 * particles);
}

// ---- Links

StaticLink link_of(double yields, double breaks) {
  return {0, 1, Vector3d(1, 0, 0), 0.5, 8, yields, breaks};
}

// The second particle's place, where the first is at 0.
VectorXd pair_with(const Vector3d& second) {
  VectorXd x = zeros(2);
  x.tail<3>() = second;
  return x;
}

const std::vector<Matrix3d>& straight_frames() {
  static const std::vector<Matrix3d> frames(2, Matrix3d::Identity());
  return frames;
}

// x to y, y to z, z to x, and the frame of the second particle's hair, which no link asks for.
std::vector<Matrix3d> turned_frames() {
  Matrix3d cycle;
  cycle << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return {cycle, Matrix3d::Identity()};
}

VectorXd one_number(double value) {
  return VectorXd::Constant(1, value);
}

VectorXd forces(const std::vector<StaticLink>& links, const std::vector<Matrix3d>& frames,
                const VectorXd& largest, const VectorXd& x) {
  VectorXd f = VectorXd::Zero(x.size());
  add_link_force(links, frames, largest, x, f);
  return f;
}

VectorXd products(const std::vector<StaticLink>& links, const VectorXd& largest, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(dx.size());
  add_link_product(links, largest, dx, df);
  return df;
}

// Five particles, three links: a new one, a worn one that has 0.75 of its strength, and one that is broken.
struct Linked {
  std::vector<StaticLink> links = {{0, 1, Vector3d(0.2, -0.4, 0.1), 0.5, 8, 0.8, 2.1},
                                   {3, 1, Vector3d(0.3, 0.1, 0.2), 0.4, 6, 1.2, 3.2},
                                   {2, 4, Vector3d(-0.1, 0.5, 0.3), 0.6, 9, 0.9, 1.9}};
  std::vector<Matrix3d> frames;
  VectorXd largest = Vector3d(0.5, 1.7, 2.5), x = scattered_vector(15, 1);
  Linked() {
    Scatter source(4);
    for (int i = 0; i < 5; ++i) {
      const double angle = source.uniform(0.5, 2.5);
      frames.push_back(Eigen::AngleAxisd(angle, ordinary_direction(source)).toRotationMatrix());
    }
  }

  // New links.
  Linked fresh() const {
    Linked same = *this;
    same.largest.setZero();
    return same;
  }

  // New links that are as weak as these: the second has 0.75 of its strength, and the third is broken.
  Linked as_weak_new_links() const {
    Linked same = fresh();
    same.links[1].stiffness *= 0.75;
    same.links[2].stiffness = 0;
    return same;
  }

  // The same in frames that are not turned.
  Linked straight() const {
    Linked same = *this;
    for (StaticLink& link : same.links) link.offset = frames[link.a] * link.offset;
    same.frames.assign(5, Matrix3d::Identity());
    return same;
  }
};

const std::string kCompared =
    " of a new link, one that has 0.75 of its strength, and a broken one, compared with that of new links "
    "that "
    "are less stiff";

VectorXd stretches_of(const Linked& s) {
  VectorXd stretches = Vector3d::Zero();
  remember_stretches(s.links, s.frames, s.x, stretches);
  return stretches;
}

}  // namespace

TEST(Strengths, FallsFromOneToZero) {
  for (const auto& [largest, expected] :
       {std::pair(0.0, 1.0), {1.0, 1.0}, {1.5, 0.75}, {2.0, 0.5}, {3.0, 0.0}, {40.0, 0.0}})
    EXPECT_NUMBER(link_strength(link_of(1, 3), largest), expected, 1e-12)
        << "a link that yields at 1 and breaks at 3; its largest stretch was " << largest;
}

TEST(Strengths, OfALinkThatBreaksAtOnce) {
  for (const auto& [largest, expected] : {std::pair(1.9, 1.0), {2.0, 1.0}, {2.1, 0.0}})
    EXPECT_NUMBER(link_strength(link_of(2, 2), largest), expected, 0)
        << "a link that yields and breaks at 2; its largest stretch was " << largest;
}

TEST(Histories, KeepsTheLargest) {
  VectorXd largest = one_number(0);
  double most = 0;
  for (const double at : {1.25, 2.0, 1.5, 1.0, -0.5, 1.0}) {
    most = std::max(most, std::abs(at - 1) / 0.5);
    remember_stretches(std::vector{link_of(1, 3)}, straight_frames(), pair_with(Vector3d(at, 0, 0)), largest);
    EXPECT_NUMBER(largest[0], most, 1e-12)
        << "the largest stretch so far; the particle is at x = " << at
        << " now, was meant to be at 1, and stretches are multiples of 0.5 m";
  }
}

TEST(Histories, MeasuresEachLink) {
  const Linked s = Linked().straight();
  VectorXd expected(3);
  for (int l = 0; l < 3; ++l) {
    const StaticLink& link = s.links[l];
    const Vector3d a = s.x.segment<3>(3 * link.a), b = s.x.segment<3>(3 * link.b);
    expected[l] = (b - a - link.offset).norm() / link.length;
  }
  expect_numbers(stretches_of(s), expected, 1e-12, "the largest stretches of three new links");
}

TEST(TurnedFrames, MeasuresFromTheFrame) {
  VectorXd largest = one_number(0);
  remember_stretches(std::vector{link_of(1, 3)}, turned_frames(), pair_with(Vector3d(0, 1, 0)), largest);
  EXPECT_NUMBER(largest[0], 0, 1e-12)
      << "the stretch of a link with the offset (1, 0, 0) in a frame that takes x to y; b is at (0, 1, 0)";
}

TEST(LinkEnergies, OfOneLink) {
  const double energy =
      link_energy(std::vector{link_of(1, 3)}, straight_frames(), one_number(0), pair_with(Vector3d(1, 2, 0)));
  EXPECT_NUMBER(energy, 16, 1e-11) << "J, of 8 N/m over 2 m";
}

TEST(WornLinks, OfAWornLink) {
  EXPECT_NUMBER(
      link_energy(std::vector{link_of(1, 3)}, straight_frames(), one_number(2), pair_with(Vector3d(1, 2, 0))),
      8, 1e-11)
      << "J, of 8 N/m over 2 m, when half of the link's strength is left";
}

TEST(LinkForces, PullsBothEnds) {
  expect_entries(forces({link_of(1, 3)}, straight_frames(), one_number(0), pair_with(Vector3d(1, 0, 2))),
                 vector({0, 0, 16, 0, 0, -16}), 1e-11,
                 "the force of a link whose b should be at (1, 0, 0), and is 2 m above it, 8 N/m");
}

TEST(TurnedFrames, PullsToWhereTheFrameIs) {
  const VectorXd x = pair_with(Vector3d(0, 1, 2));
  expect_entries(forces({link_of(1, 3)}, turned_frames(), one_number(0), x), vector({0, 0, 16, 0, 0, -16}),
                 1e-11,
                 "the force of a link whose b should be at (0, 1, 0), in a frame that takes x to y, and is 2 "
                 "m above it, 8 N/m");
}

// Links are numbered, and so are particles: a frame is that of the particle a.
TEST(TurnedFrames, TakesTheFrameOfEachLinksParticle) {
  const Linked s, same = s.straight();
  expect_numbers(
      stretches_of(s), stretches_of(same), 1e-12,
      "stretches of three links, compared with those of links whose offsets are turned in place of frames");
  expect_entries(
      forces(s.links, s.frames, s.largest, s.x), forces(same.links, same.frames, s.largest, s.x), 1e-11,
      "forces of three links, compared with those of links whose offsets are turned in place of frames");
}

TEST(Added, AddsToWhatIsThereByAddLinkForce) {
  const Linked s;
  expect_added([&](VectorXd& f) { add_link_force(s.links, s.frames, s.largest, s.x, f); }, VectorXd::Ones(15),
               1e-11, "f");
}

TEST(LinkForces, IsTheSlopeOfTheEnergy) {
  const Linked s = Linked().straight().fresh();
  expect_force(
      forces(s.links, s.frames, s.largest, s.x),
      [&](const VectorXd& x) { return link_energy(s.links, s.frames, s.largest, x); }, s.x, 1, 10);
}

TEST(WornLinks, OfABrokenLinkIsNothing) {
  const VectorXd x = pair_with(Vector3d(5, 1, 2));
  expect_entries(forces({link_of(1, 3)}, straight_frames(), one_number(3), x), zeros(2), 0,
                 "the force of a link that broke", "0");
}

TEST(WornLinks, TakeTheirOwnStrength) {
  const Linked s;
  const Linked fresh = s.as_weak_new_links();
  EXPECT_NUMBER(link_energy(s.links, s.frames, s.largest, s.x),
                link_energy(fresh.links, s.frames, fresh.largest, s.x), 1e-11)
      << "the energy" << kCompared;
  expect_entries(forces(s.links, s.frames, s.largest, s.x), forces(fresh.links, s.frames, fresh.largest, s.x),
                 1e-11, "the force" + kCompared);
}

TEST(LinkProducts, IsTheSlopeOfTheForce) {
  const Linked s = Linked().straight().fresh();
  for (const int which : {2, 3}) {
    const VectorXd dx = scattered_vector(15, which);
    expect_product(
        products(s.links, s.largest, dx),
        [&](const VectorXd& x) { return forces(s.links, s.frames, s.largest, x); }, s.x, dx, 1, 10);
  }
}

TEST(LinkProducts, TakeTheStrengthOfEachLink) {
  const Linked s, fresh = s.as_weak_new_links();
  const VectorXd dx = scattered_vector(15, 2);
  expect_entries(products(s.links, s.largest, dx), products(fresh.links, fresh.largest, dx), 1e-11,
                 "the product" + kCompared);
}

TEST(Added, AddsToWhatIsThereByAddLinkProduct) {
  const Linked s;
  const VectorXd dx = scattered_vector(15, 6);
  expect_added([&](VectorXd& df) { add_link_product(s.links, s.largest, dx, df); }, VectorXd::Ones(15), 1e-11,
               "df");
}

// A force is a stiffness times a length, whatever their sizes: hair is smaller than this by far.
TEST(OtherUnits, OfLinksOfAnySize) {
  const Linked s;
  const VectorXd expected = forces(s.links, s.frames, s.largest, s.x), stretches = stretches_of(s);
  for (const double scale : {0x1p-50, 0x1p40}) {
    std::vector<StaticLink> links = s.links;
    for (StaticLink& link : links) link.length *= scale, link.offset *= scale;
    expect_entries(forces(links, s.frames, s.largest, scale * s.x) / scale, expected, 1e-11,
                   "forces, in units of 2^-50 or 2^40 m");
    VectorXd again = VectorXd::Zero(3);
    remember_stretches(links, s.frames, scale * s.x, again);
    expect_entries(again, stretches, 1e-11, "stretches of links that are 2^-50 or 2^40 times as long");
  }
}

TEST(LinkProducts, IsSymmetric) {
  const Linked s;
  expect_symmetric([&](const VectorXd& dx) { return products(s.links, s.largest, dx); },
                   scattered_vector(15, 4), scattered_vector(15, 5), 1e-11);
}

// ---- Strips

namespace {

// A triangle in the plane z = 0, whose normal is z, and a point `height` above (0.5, 0.75).
VectorXd above_triangle(double height, double x = 0.5, double y = 0.75) {
  return vector({0, 0, 0, 2, 0, 0, 0, 3, 0, x, y, height});
}

VectorXd tangents_of(const Vector3d& of_point, const std::array<Vector3d, 3>& of_corners) {
  VectorXd tangents(12);
  tangents << of_corners[0], of_corners[1], of_corners[2], of_point;
  return tangents;
}

bool touch(const VectorXd& x, double side, StripContact& contact, const VectorXd& tangents = zeros(4)) {
  return touch_strip(3, {0, 1, 2}, side, 0.25, x, tangents, contact);
}

double weight_of(const Vector3d& of_point, const std::array<Vector3d, 3>& of_corners) {
  StripContact contact;
  EXPECT_TRUE(touch(above_triangle(0.1), 1, contact, tangents_of(of_point, of_corners)));
  return contact.weight;
}

// The contact of that point; the weight is 0.5.
StripContact some_contact(double side = 1) {
  return {3, {0, 1, 2}, {0.5, 0.25, 0.25}, Vector3d(0, 0, side), 0.5};
}

constexpr StripLaw kLaw{0.25, 40, 0.6};

VectorXd strip_forces(const std::vector<StripContact>& contacts, const VectorXd& x) {
  VectorXd f = VectorXd::Zero(x.size());
  add_strip_force(contacts, kLaw, x, f);
  return f;
}

VectorXd strip_products(const std::vector<StripContact>& contacts, const VectorXd& x, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  add_strip_product(contacts, kLaw, x, dx, df);
  return df;
}

// Two contacts that share particles, with normals along no axis. One of them presses.
struct Pressed {
  std::vector<StripContact> contacts = {{3, {0, 1, 2}, {0.2, 0.5, 0.3}, Vector3d(2, -1, 2) / 3, 0.7},
                                        {4, {3, 2, 0}, {0.6, 0.3, 0.1}, Vector3d(1, 2, -2) / 3, 0.4}};
  VectorXd x = scattered_vector(15, 1);
  Pressed() { x.segment<3>(9) -= 2 * contacts[0].normal; }
};

VectorXd after_friction(const VectorXd& x, const VectorXd& inverse_mass, double h, VectorXd v) {
  apply_strip_friction(std::vector{some_contact()}, kLaw, inverse_mass, h, x, v);
  return v;
}

}  // namespace

TEST(Touches, FindsAPointNearby) {
  for (const double side : {1.0, -1.0})
    for (const double height : {0.1, -0.1}) {
      StripContact contact;
      EXPECT_TRUE(touch(above_triangle(height), side, contact))
          << "a point " << height << " above a triangle, side " << side << ", thickness 0.25";
    }
}

TEST(Touches, FindsNothingFarAway) {
  StripContact contact;
  for (const double height : {0.3, -0.3})
    EXPECT_FALSE(touch(above_triangle(height), 1, contact)) << height << " above; the thickness is 0.25";
  for (const auto& [x, y] : {std::pair(-0.1, 1.0), {1.0, -0.1}, {1.2, 1.6}})
    EXPECT_FALSE(touch(above_triangle(0.1, x, y), 1, contact))
        << "over (" << x << ", " << y << "), outside of the triangle (0, 0), (2, 0), (0, 3)";
}

TEST(Touches, SaysWhereThePointIs) {
  for (const double side : {1.0, -1.0}) {
    StripContact contact;
    EXPECT_TRUE(touch(above_triangle(0.1), side, contact)) << "a point 0.1 above a triangle, thickness 0.25";
    EXPECT_EQ(contact.point, 3);
    EXPECT_EQ(contact.corners, (std::array{0, 1, 2}));
    expect_entries(contact.normal, Vector3d(0, 0, side), 1e-12,
                   "the normal, side " + std::to_string(static_cast<int>(side)));
    expect_numbers(Vector3d(contact.shares.data()), Vector3d(0.5, 0.25, 0.25), 1e-12,
                   "the shares of (0.5, 0.75) in the triangle (0, 0), (2, 0), (0, 3)");
  }
  // No right angle, and along no axis.
  VectorXd x = scattered_vector(12, 6);
  const Vector3d a = x.head<3>(), b = x.segment<3>(3), c = x.segment<3>(6),
                 normal = (b - a).cross(c - a).normalized();
  x.tail<3>() = 0.5 * a + 0.2 * b + 0.3 * c - 0.1 * normal;
  StripContact contact;
  EXPECT_TRUE(touch(x, -1, contact)) << "a point 0.1 below a triangle, thickness 0.25";
  expect_entries(contact.normal, -normal, 1e-12, "the normal of a triangle along no axis, side -1");
  expect_numbers(Vector3d(contact.shares.data()), Vector3d(0.5, 0.2, 0.3), 1e-12,
                 "the shares in a triangle along no axis");
}

TEST(FlatTriangles, FindsEdgesAndNoFlatTriangle) {
  StripContact contact;
  for (const auto& [x, y] : {std::pair(0.5, 0.0), {0.0, 1.5}, {0.0, 0.0}}) {
    EXPECT_TRUE(touch(above_triangle(0.125, x, y), 1, contact))
        << "over (" << x << ", " << y
        << "), an edge or a corner of the triangle (0, 0), (2, 0), (0, 3): a share of 0 is not negative";
    EXPECT_FALSE(touch(above_triangle(0.25, x, y), 1, contact)) << "as far away as the thickness, 0.25";
  }
  VectorXd flat = above_triangle(0.1);
  flat.segment<3>(6) = 2 * flat.segment<3>(3);
  EXPECT_FALSE(touch(flat, 1, contact)) << "a triangle without an area";
}

// Only an area of exactly 0 is "without an area".
TEST(FlatTriangles, FindsTrianglesOfAnySize) {
  StripContact contact;
  for (const double scale : {0x1p-50, 0x1p50}) {
    const VectorXd x = scale * above_triangle(0.125);
    EXPECT_TRUE(touch_strip(3, {0, 1, 2}, 1, 0.25 * scale, x, zeros(4), contact))
        << "a point over a triangle with edges of some " << scale << " m";
  }
  VectorXd thin = above_triangle(0.125, 0.5, 0x1p-48);
  thin[7] = 0x1p-45;
  EXPECT_TRUE(touch(thin, 1, contact)) << "a triangle that is 2 m long and 2^-45 m high";
}

TEST(Weights, WeighsOneWithoutTangents) {
  const Vector3d none = Vector3d::Zero();
  EXPECT_NUMBER(weight_of(none, {none, none, none}), 1, 1e-12) << "the weight where all tangents are 0";
}

TEST(Weights, WeighsHowMuchHairsCross) {
  const Vector3d z(0, 0, 1), y(0, 1, 0), slanted = Vector3d(0, 4, 3) / 5;
  EXPECT_NUMBER(weight_of(z, {z, z, z}), 0, 1e-12) << "all tangents are z: hairs that lie side by side merge";
  EXPECT_NUMBER(weight_of(z, {y, y, y}), 1, 1e-12)
      << "the point's tangent is z, the strip's are y: hairs cross";
  EXPECT_NUMBER(weight_of(z, {slanted, slanted, slanted}), 0.4, 1e-12)
      << "the point's tangent is z, the strip's are (0, 0.8, 0.6)";
  EXPECT_NUMBER(weight_of(z, {slanted, y, z}), 1 - 0.5 * 0.6 - 0.25, 1e-12)
      << "tangents (0, 0.8, 0.6), y and z of corners with shares 0.5, 0.25 and 0.25";
}

TEST(NoDirections, GivesAHairWithoutADirectionItsFullWeight) {
  const Vector3d z(0, 0, 1), none = Vector3d::Zero();
  EXPECT_NUMBER(weight_of(none, {z, z, z}), 1, 1e-12) << "the point's tangent is 0, the strip's are z";
  EXPECT_NUMBER(weight_of(z, {z, none, none}), 0.5, 1e-12)
      << "the tangents of two corners with shares of 0.25 are 0, all others are z";
}

TEST(Weights, DoesNotAskForSigns) {
  const Vector3d z(0, 0, 1);
  EXPECT_NUMBER(weight_of(-z, {z, z, z}), 0, 1e-12)
      << "the point's tangent is -z, the strip's are z: the hair was turned end for end";
  EXPECT_NUMBER(weight_of(z, {z, -z, z}), 0, 1e-12) << "one corner's tangent is -z, all others are z";
}

// A unit vector's product with itself is often a little more than 1.
TEST(Weights, NeverGivesANegativeWeight) {
  for (int which = 0; which < 20; ++which) {
    const Vector3d t = Vector3d(scattered_vector(3, which)).normalized();
    EXPECT_GE(weight_of(t, {t, t, t}), 0)
        << "all tangents are " << particles_in_words(t) << ": 1 - t.t is negative by rounding alone";
  }
}

TEST(StripForces, OfOneContact) {
  EXPECT_NUMBER(strip_energy(std::vector{some_contact()}, kLaw, above_triangle(0.05)), 0.4, 1e-12)
      << "J: 0.2 m too near, 40 N/m, weight 0.5";
  EXPECT_NUMBER(strip_energy(std::vector{some_contact(-1)}, kLaw, above_triangle(0.05)), 0.9, 1e-12)
      << "J: on the wrong side, 0.3 m too near";
}

TEST(StripForces, OfAPointFarAwayIsNothing) {
  EXPECT_NUMBER(strip_energy(std::vector{some_contact()}, kLaw, above_triangle(0.3)), 0, 0)
      << "farther than 0.25 m";
}

TEST(StripForces, PushesThePointAndTheCorners) {
  VectorXd expected = zeros(4);
  expected[11] = 4;
  expected[2] = -2;
  expected[5] = expected[8] = -1;
  expect_entries(strip_forces({some_contact()}, above_triangle(0.05)), expected, 1e-12,
                 "forces of a contact 0.2 m too near, 40 N/m, weight 0.5, shares 0.5, 0.25, 0.25");
  expect_entries(strip_forces({some_contact()}, above_triangle(0.3)), zeros(4), 0,
                 "forces of a point farther away than the thickness", "0");
}

TEST(Added, AddsToWhatIsThereByAddStripForce) {
  const Pressed s;
  const VectorXd dx = scattered_vector(15, 7);
  expect_added([&](VectorXd& f) { add_strip_force(s.contacts, kLaw, s.x, f); }, VectorXd::Ones(15), 1e-11,
               "f");
  expect_added([&](VectorXd& df) { add_strip_product(s.contacts, kLaw, s.x, dx, df); }, VectorXd::Ones(15),
               1e-11, "df");
}

TEST(StripForces, IsTheSlopeOfTheEnergy) {
  const Pressed s;
  expect_force(
      strip_forces(s.contacts, s.x), [&](const VectorXd& x) { return strip_energy(s.contacts, kLaw, x); },
      s.x, 1, 10);
}

TEST(StripForces, BalancesRightAfterTouching) {
  VectorXd x = scattered_vector(12, 6);
  const Vector3d a = x.head<3>(), b = x.segment<3>(3), c = x.segment<3>(6);
  x.tail<3>() = 0.3 * a + 0.3 * b + 0.4 * c + 0.1 * (b - a).cross(c - a).normalized();
  StripContact contact;
  ASSERT_TRUE(touch(x, 1, contact)) << "a point 0.1 over a triangle; touch_strip must work first";
  expect_balanced(strip_forces({contact}, x), x, 1e-11);
}

TEST(StripProducts, IsTheSlopeOfTheForce) {
  const Pressed s;
  for (const int which : {2, 3}) {
    const VectorXd dx = scattered_vector(15, which);
    expect_product(
        strip_products(s.contacts, s.x, dx), [&](const VectorXd& x) { return strip_forces(s.contacts, x); },
        s.x, dx, 1, 10);
  }
  // Two points, the first one farther away than the thickness.
  VectorXd two(15);
  two << above_triangle(0.3), 0.5, 0.75, 0.05;
  const VectorXd dx = scattered_vector(15, 4);
  std::vector<StripContact> contacts(2, some_contact());
  contacts[1].point = 4;
  expect_entries(strip_products(contacts, two, dx), strip_products({contacts[1]}, two, dx), 1e-12,
                 "the product of a contact that does not press and of one that does, compared with that of "
                 "the second alone");
  expect_entries(strip_products({some_contact()}, above_triangle(0.3), scattered_vector(12, 1)), zeros(4), 0,
                 "the product of a point farther away than the thickness", "0");
}

// The pressure is 4 N, so that friction is 2.4 N at most.
TEST(Frictions, SlipsWithCoulombsForce) {
  for (const double inverse : {0.5, 1.0, 2.0}) {
    VectorXd v = zeros(4), inverse_mass = VectorXd::Zero(4);
    v.tail<3>() = Vector3d(3, 4, 7);
    inverse_mass[3] = inverse;
    VectorXd expected = v;
    expected.tail<3>() = Vector3d(3, 4, 0) * (5 - 0.24 * inverse) / 5 + Vector3d(0, 0, 7);
    expect_entries(
        after_friction(above_triangle(0.05), inverse_mass, 0.1, v), expected, 1e-12,
        "velocities after 0.1 s, (3, 4, 7) before; the corners are pinned, the point has 2, 1 or 0.5 kg",
        "rounding", v);
  }
}

// All particles move, each has a mass of its own: W is 1/2 + 0.25/4 + (1 + 2)/16 = 0.75 / kg.
TEST(Frictions, StopsThePointBesideCornersThatMove) {
  VectorXd v = scattered_vector(12, 3);
  const Eigen::Vector4d inverse_mass(0.25, 1, 2, 0.5);
  const Vector3d slip = v.tail<3>() - 0.5 * v.head<3>() - 0.25 * v.segment<3>(3) - 0.25 * v.segment<3>(6);
  const Vector3d impulse = -Vector3d(slip.x(), slip.y(), 0) / 0.75;
  VectorXd expected = v;
  expected.tail<3>() += 0.5 * impulse;
  const double shares[] = {0.5, 0.25, 0.25};
  for (int j = 0; j < 3; ++j) expected.segment<3>(3 * j) -= shares[j] * inverse_mass[j] * impulse;
  expect_entries(after_friction(above_triangle(0.05), inverse_mass, 10, v), expected, 1e-12,
                 "velocities after 10 s, inverse masses of corners 0.25, 1, 2 and of the point 0.5 / kg");
}

TEST(PinnedFrictions, ChangesNothingWithoutFriction) {
  StripLaw smooth = kLaw;
  smooth.friction = 0;
  const VectorXd x = above_triangle(0.05), before = scattered_vector(12, 3);
  VectorXd v = before;
  apply_strip_friction(std::vector{some_contact()}, smooth, Eigen::Vector4d(0.25, 1, 2, 0.5), 0.1, x, v);
  EXPECT_EQ(v, before) << "velocities where mu is 0";
}

TEST(PinnedFrictions, ChangesNothingThatIsPinnedOrAtRest) {
  const VectorXd x = above_triangle(0.05), v = scattered_vector(12, 3);
  EXPECT_EQ(after_friction(x, VectorXd::Zero(4), 10, v), v) << "all particles are pinned";
  EXPECT_EQ(after_friction(x, Eigen::Vector4d(0.25, 1, 2, 0.5), 10, zeros(4)), zeros(4)) << "nothing moves";
}

TEST(Frictions, StopsAndDoesNotReverse) {
  VectorXd v = zeros(4), inverse_mass = VectorXd::Zero(4), expected = zeros(4);
  v.tail<3>() = Vector3d(0.3, 0.4, 7);
  expected[11] = 7;
  inverse_mass[3] = 2;
  expect_entries(after_friction(above_triangle(0.05), inverse_mass, 10, v), expected, 1e-12,
                 "velocities after 10 s; the corners are pinned");
  EXPECT_EQ(after_friction(above_triangle(0.3), inverse_mass, 10, v), v) << "nothing presses";
}

// The second of two equal contacts finds what the first one left.
TEST(FrictionOrder, GoesContactAfterContact) {
  const VectorXd x = above_triangle(0.05);
  VectorXd v = zeros(4), inverse_mass = VectorXd::Zero(4);
  v[9] = 1.5;
  inverse_mass[3] = 0.5;
  const std::vector<StripContact> twice(2, some_contact());
  apply_strip_friction(twice, kLaw, inverse_mass, 0.8, x, v);
  EXPECT_NUMBER(v[9], 0, 1e-12) << "m/s: 1.5, less 0.96 of the first contact; the second one stops the rest";
  // A contact whose particles are all pinned changes nothing for the next one.
  VectorXd two = zeros(5), w = zeros(5);
  two.head(12) = x;
  two.tail<3>() = x.tail<3>();
  std::vector<StripContact> contacts(2, some_contact());
  contacts[1].point = 4;
  w[12] = 1.5;
  Eigen::VectorXd masses = VectorXd::Zero(5);
  masses[4] = 0.5;
  apply_strip_friction(contacts, kLaw, masses, 0.8, two, w);
  EXPECT_NUMBER(w[12], 0.54, 1e-12)
      << "m/s: 1.5, less 0.96; the contact before it is between pinned particles";
}

TEST(OtherUnits, OfPointsOfAnySpeed) {
  const Eigen::Vector4d inverse_mass(0.25, 1, 2, 0.5);
  const VectorXd before = scattered_vector(12, 3),
                 after = after_friction(above_triangle(0.05), inverse_mass, 10, before);
  expect_entries(after_friction(above_triangle(0.05), inverse_mass, 10, 0x1p-60 * before) * 0x1p60, after,
                 1e-12, "velocities after 10 s, in units of 2^-60 m/s: the point sticks");
}

TEST(Frictions, NeverAccelerates) {
  for (int which = 0; which < 10; ++which) {
    const Pressed s;
    const VectorXd inverse_mass = scattered_vector(5, which).cwiseAbs(),
                   before = scattered_vector(15, 20 + which);
    VectorXd v = before;
    apply_strip_friction(s.contacts, kLaw, inverse_mass, 0.1 * which, s.x, v);
    double was = 0, is = 0;
    Vector3d gained = Vector3d::Zero();
    for (int i = 0; i < 5; ++i) {
      was += before.segment<3>(3 * i).squaredNorm() / inverse_mass[i] / 2;
      is += v.segment<3>(3 * i).squaredNorm() / inverse_mass[i] / 2;
      gained += (v - before).segment<3>(3 * i) / inverse_mass[i];
    }
    EXPECT_LE(is, was * (1 + 1e-12))
        << "the kinetic energy after friction, in J, compared with that before it";
    expect_entries(gained, zeros(1), 1e-10, "the momentum that friction adds to all particles together");
  }
}

int main(int argc, char** argv) {
  static const std::vector<StaticLink> links;
  static const std::vector<Matrix3d> frames;
  static const std::vector<StripContact> contacts;
  static const VectorXd none;
  static VectorXd results;
  static StripContact contact;
  return run(
      argc, argv,
      {{"link_strength", [] { link_strength(link_of(1, 2), 0); }},
       {"remember_stretches", [] { remember_stretches(links, frames, none, results); }},
       {"link_energy", [] { link_energy(links, frames, none, none); }},
       {"add_link_force", [] { add_link_force(links, frames, none, none, results); }, {"link_energy"}},
       {"add_link_product", [] { add_link_product(links, none, none, results); }, {"add_link_force"}},
       {"touch_strip", [] { touch(above_triangle(0.1), 1, contact); }},
       {"strip_energy", [] { strip_energy(contacts, kLaw, none); }},
       {"add_strip_force",
        [] { add_strip_force(contacts, kLaw, none, results); },
        {"strip_energy", "touch_strip"}},
       {"add_strip_product",
        [] { add_strip_product(contacts, kLaw, none, none, results); },
        {"add_strip_force"}},
       {"apply_strip_friction", [] { apply_strip_friction(contacts, kLaw, none, 0.1, none, results); }}});
}

// The public checks of H10, function by function; each is checked with inputs that are made here, so that an
// error in one does not show in the others. Every failure prints the input, what was expected, what came, the
// error and its bound. The contract is in hair/strand_synthesis.h.

#include "hair/strand_synthesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check.h"
#include "derivative.h"

using namespace checks;
using Eigen::VectorXd;
using hair::GuideFrames, hair::GuideHair, hair::Matrix3d, hair::RootFrame, hair::Vector3d;

namespace {

constexpr double kPi = std::numbers::pi;
using Corners = std::array<Vector3d, 3>;
using Weights = std::array<double, 3>;

void expect_point(const Vector3d& actual, const Vector3d& expected, const std::string& what) {
  expect_entries(actual, expected, 1e-12, what);
}

void expect_all(const VectorXd& actual, const VectorXd& expected, const std::string& what) {
  for (Eigen::Index i = 0; i < expected.size() / 3; ++i)
    expect_point(actual.segment<3>(3 * i), expected.segment<3>(3 * i), what + ", point " + std::to_string(i));
}

std::string in_powers_of_2(double unit) {
  return "2^" + std::to_string(std::ilogb(unit));
}

// ---- Guides

struct Lock {
  RootFrame root;
  VectorXd points;
  GuideHair view() const { return {root, {points.data(), points.size()}}; }
};

Matrix3d some_turn(double angle = 2) {
  return Eigen::AngleAxisd(angle, Vector3d(2, -1, 2).normalized()).toRotationMatrix();
}

// The root frame whose axis, side and axis x side are the columns of `axes`.
RootFrame root_of(const Vector3d& position, const Matrix3d& axes) {
  return {position, axes.col(0), axes.col(1)};
}

// A guide that grows up from its first point, with the side x.
Lock upright(const VectorXd& points) {
  return {{points.head<3>(), Vector3d(0, 0, 1), Vector3d(1, 0, 0)}, points};
}

// A guide of n points. Seen from a root with the axis z, the side x and the position 0 they would be `seen`.
Lock lock(const RootFrame& root, const VectorXd& seen) {
  Lock made{root, seen};
  Matrix3d axes;
  axes << root.side, root.axis.cross(root.side), root.axis;
  for (Eigen::Index at = 0; at < seen.size(); at += 3)
    made.points.segment<3>(at) = root.position + axes * seen.segment<3>(at);
  return made;
}

VectorXd line(int n, const Vector3d& to) {
  VectorXd points(3 * n);
  for (int i = 0; i < n; ++i) points.segment<3>(3 * i) = to * i / (n - 1);
  return points;
}

// A helix about z that starts at 0, which is at the angle `phase` on its circle.
VectorXd curl(int n, double radius, double pitch, double turns, double phase) {
  VectorXd points(3 * n);
  const Vector3d start(std::cos(phase), std::sin(phase), 0);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * turns * i / (n - 1);
    points.segment<3>(3 * i) =
        radius * (Vector3d(std::cos(angle + phase), std::sin(angle + phase), 0) - start) +
        Vector3d(0, 0, pitch * angle / (2 * kPi));
  }
  return points;
}

// ---- Calls, with junk where results go

VectorXd interpolated(const std::array<Lock, 3>& locks, const Weights& weights, const RootFrame& root) {
  VectorXd child = VectorXd::Constant(locks[0].points.size(), 1e3);
  hair::interpolate({locks[0].view(), locks[1].view(), locks[2].view()}, weights, root, child);
  return child;
}

GuideFrames carried(const Lock& guide) {
  const Eigen::Index n = guide.points.size() / 3;
  GuideFrames frames{VectorXd::Constant(n, 1e3),
                     std::vector<Matrix3d>(static_cast<std::size_t>(n), Matrix3d::Constant(1e3))};
  carry_along(guide.points, frames);
  return frames;
}

VectorXd extrapolated(const Lock& guide, const GuideFrames& frames, const Vector3d& root, double spread) {
  VectorXd child = VectorXd::Constant(guide.points.size(), 1e3);
  extrapolate(guide.points, frames, root, spread, child);
  return child;
}

GuideFrames no_turns(int n) {
  return {VectorXd::LinSpaced(n, 0, 1),
          std::vector<Matrix3d>(static_cast<std::size_t>(n), Matrix3d::Identity())};
}

}  // namespace

// ---- (1)

namespace {

const Corners kTriangle = {Vector3d(0, 0, 1), Vector3d(4, 0, 1), Vector3d(0, 3, 1)};

// The weights are the same wherever the triangle lies.
void expect_weights(const Vector3d& root, const Weights& expected, const std::string& where,
                    double unit = 1) {
  for (const Vector3d& way : {Vector3d(0, 0, 0), Vector3d(-2, 1, 3)}) {
    const bool inside = std::ranges::all_of(expected, [](double weight) { return weight > 0; });
    // A fourth corner at the root would win over all edges.
    struct {
      Corners corners;
      Vector3d behind;
    } laid{kTriangle, inside ? Vector3d(Vector3d::Constant(std::nan(""))) : Vector3d(unit * (root + way))};
    for (Vector3d& corner : laid.corners) corner = unit * (corner + way);
    const Weights weights = hair::root_weights(laid.corners, unit * (root + way));
    for (int k = 0; k < 3; ++k)
      EXPECT_NUMBER(weights[k], expected[k], 1e-11)
          << "weight " << k << " of a root " << where
          << " the triangle (0, 0, 1), (4, 0, 1), (0, 3, 1), moved by (" << way.transpose()
          << "), and all lengths times " << unit
          << (unit != 1 ? "\nhint       = other checks ask for this in metres: here only the unit differs"
              : inside && weights[k] == 0
                  ? "\nhint       = 0 inside of a triangle: was the root taken for one beside it, or the "
                    "triangle for a thin one?"
                  : "");
  }
}

}  // namespace

TEST(WeightsInside, OfCornersAndOfTheMiddle) {
  expect_weights(Vector3d(0, 0, 1), {1, 0, 0}, "at a corner of");
  expect_weights(Vector3d(4, 0, 1), {0, 1, 0}, "at a corner of");
  expect_weights(Vector3d(0, 3, 1), {0, 0, 1}, "at a corner of");
  expect_weights(Vector3d(4.0 / 3, 1, 1), {1.0 / 3, 1.0 / 3, 1.0 / 3}, "in the middle of");
  expect_weights(Vector3d(1, 1.5, 1), {0.25, 0.25, 0.5}, "inside of");
}

TEST(WeightsInside, OfARootAboveTheTriangle) {
  expect_weights(Vector3d(1, 1.5, 7), {0.25, 0.25, 0.5}, "6 above the inside of");
  expect_weights(Vector3d(1, 1.5, -2), {0.25, 0.25, 0.5}, "3 below the inside of");
}

TEST(WeightsOutside, OfARootBesideTheTriangleAreThoseOfTheNearestPoint) {
  expect_weights(Vector3d(1, -2, 1), {0.75, 0.25, 0}, "beside the first edge of");
  expect_weights(Vector3d(-2, 1.5, 1), {0.5, 0, 0.5}, "beside the last edge of");
  expect_weights(Vector3d(-1, -1, 1), {1, 0, 0}, "beyond the first corner of");
  expect_weights(Vector3d(9, 1, 4), {0, 1, 0}, "beyond the second corner of");
  // The nearest point of the edge from (4, 0) to (0, 3) is its middle; weights that are cut off at 0 and
  // scaled say otherwise.
  expect_weights(Vector3d(2 + 3, 1.5 + 4, 1), {0, 0.5, 0.5}, "beside the longest edge of");
  // Here the weights of the first and of the third corner are negative. The nearest point lies on the longest
  // edge.
  expect_weights(Vector3d(4, -1, 1), {0, 1, 0}, "below the second corner of");
}

TEST(Units, InAnyUnitByRootWeights) {
  for (const double unit : {0x1p-20, 0x1p20, 0x1p-90, 0x1p50}) {
    expect_weights(Vector3d(1, 1.5, 1), {0.25, 0.25, 0.5}, "inside of", unit);
    expect_weights(Vector3d(1, 1.5, 7), {0.25, 0.25, 0.5}, "6 above the inside of", unit);
    expect_weights(Vector3d(-2, 1.5, 1), {0.5, 0, 0.5}, "beside the last edge of", unit);
    expect_weights(Vector3d(2 + 3, 1.5 + 4, 1), {0, 0.5, 0.5}, "beside the longest edge of", unit);
  }
}

TEST(NoWidth, OfTrianglesWithoutAWidth) {
  for (const Corners& corners : {Corners{Vector3d(0, 0, 0), Vector3d(1, 1, 1), Vector3d(2, 2, 2)},
                                 Corners{Vector3d(0, 0, 0), Vector3d(0, 0, 0), Vector3d(2, 2, 2)},
                                 Corners{Vector3d(2, 2, 2), Vector3d(2, 2, 2), Vector3d(2, 2, 2)}}) {
    const Weights weights = hair::root_weights(corners, Vector3d(3, 3, 0));
    EXPECT_NUMBER(weights[0] + weights[1] + weights[2], 1, 1e-12) << "the sum of the weights";
    EXPECT_GE(*std::min_element(weights.begin(), weights.end()), 0);
    const Vector3d point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    expect_entries(
        point, Vector3d(2, 2, 2), 1e-5,
        "the point of three corners on the line x = y = z up to (2, 2, 2) that is nearest to (3, 3, 0)",
        "the contract's");
  }
  // A line with two corners side by side: the cross product of its edges is only rounding.
  const Vector3d end(1.1, 0.7, 1.9), aside = 1e-13 * Vector3d(0.3, -0.8, 0.5), root = end / 2 + aside / 4;
  const Corners corners = {Vector3d::Zero(), end, end + aside};
  const Weights weights = hair::root_weights(corners, root);
  EXPECT_NUMBER(weights[0] + weights[1] + weights[2], 1, 1e-6) << "the sum of the weights";
  expect_entries(weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2], root,
                 1e-6 * end.norm(),
                 "the nearest point of a triangle to a point of it, two corners of which are 1e-13 apart",
                 "the contract's: 1e-6 of the longest edge");
}

namespace {

// The nearest point, for triangles whose weights are not unique: to 1e-6 of their size.
void expect_nearest(const Corners& corners, const Vector3d& root, const Vector3d& expected,
                    const std::string& what) {
  const Weights weights = hair::root_weights(corners, root);
  EXPECT_NUMBER(weights[0] + weights[1] + weights[2], 1, 1e-6) << "the sum of the weights: " << what;
  EXPECT_GE(*std::min_element(weights.begin(), weights.end()), 0) << "the least weight: " << what;
  double size = 0;
  for (const Vector3d& corner : corners) size = std::max(size, (corner - corners[0]).norm());
  expect_entries((weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2]) / size,
                 expected / size, 2e-6, "the nearest point, over the triangle's size: " + what,
                 "the contract's: 1e-6 of the longest edge");
}

}  // namespace

// Each of the three edges is the longest once, and each order of the corners has its turn.
TEST(NoWidth, OfALineInAnyOrder) {
  const Vector3d along = Vector3d(2, -1, 2) / 3, off = Vector3d(1, 2, 0) / 4;
  std::array<int, 3> order = {0, 1, 2};
  do {
    for (const double middle : {0.0, 1e-6, 0.4, 1.0})
      for (const double at : {0.05, 0.3, 0.7, 0.95}) {
        Corners corners;
        const std::array<double, 3> places = {0, middle, 1};
        for (int k = 0; k < 3; ++k) corners[order[k]] = places[k] * along;
        expect_nearest(corners, at * along + off, at * along,
                       "corners at " + std::to_string(places[0]) + ", " + std::to_string(middle) +
                           " and 1 of a line, in the order " + std::to_string(order[0]) +
                           std::to_string(order[1]) + std::to_string(order[2]) + ", and a root beside " +
                           std::to_string(at) + " of it");
      }
  } while (std::next_permutation(order.begin(), order.end()));
}

// A triangle is thin if its height over an edge is small; no length in metres decides.
TEST(ThinTriangles, OfThinTrianglesInAnyUnit) {
  const Vector3d along = Vector3d(2, -1, 2) / 3, up = Vector3d(1, 2, 0) / std::sqrt(5.0);
  for (const double unit : {1.0, 0x1p-90, 0x1p-30, 0x1p50})
    for (const double height : {0.1, 1e-3, 1e-4}) {
      const Corners corners = {Vector3d::Zero(), unit * along, unit * (0.6 * along + height * up)};
      const Vector3d inside = 0.1 * corners[0] + 0.3 * corners[1] + 0.6 * corners[2];
      expect_nearest(corners, inside, inside,
                     "a point of a triangle whose height is " + std::to_string(height) +
                         " of its longest edge, all lengths times " + in_powers_of_2(unit));
      expect_nearest(corners, inside + 0.2 * unit * along.cross(up), inside,
                     "the same point, and the root above it");
    }
}

// ---- (2)

namespace {

void expect_mean_in(const Matrix3d& axes, const std::string& where) {
  const RootFrame root = root_of(Vector3d(1.5, 2, 3), axes);
  const std::array<Vector3d, 3> tips = {Vector3d(2, 1, 3), Vector3d(-1, 0.5, 4), Vector3d(0.5, 3, -2)};
  std::array<Lock, 3> locks;
  for (int k = 0; k < 3; ++k) locks[k] = lock(root_of(Vector3d(k, -2 * k, 5), axes), line(4, tips[k]));
  const Vector3d mean = 0.5 * tips[0] + 0.2 * tips[1] + 0.3 * tips[2];
  expect_all(interpolated(locks, {0.5, 0.2, 0.3}, root), lock(root, line(4, mean)).points,
             "the mean of three straight guides, weights 0.5, 0.2, 0.3, all frames equal, " + where);
}

}  // namespace

TEST(FlatScalp, OfFramesAlongTheAxesIsTheMeanOfTheShapes) {
  expect_mean_in(Matrix3d::Identity(), "along x, y, z");
}

TEST(FlatScalp, OfEqualFramesIsTheMeanOfTheShapes) {
  expect_mean_in(some_turn(), "along no axes");
}

TEST(CurvedScalp, OfOneGuideIsItsShapeAtAnotherRoot) {
  std::array<Lock, 3> locks;
  for (int k = 0; k < 3; ++k)
    locks[k] = lock(root_of(Vector3d(k, 0, 0), some_turn(k)), curl(9, 0.5, 0.3, 1.5, k));
  for (int k = 0; k < 3; ++k) {
    Weights weights{};
    weights[k] = 1;
    expect_all(interpolated(locks, weights, locks[k].root), locks[k].points, "a guide where it grows itself");
    const RootFrame other = root_of(Vector3d(7, 8, 9), some_turn(-1));
    expect_all(interpolated(locks, weights, other), lock(other, curl(9, 0.5, 0.3, 1.5, k)).points,
               "a guide's shape at a root that looks another way. Is it turned from the guide's frame into "
               "the child's?");
  }
}

// A head that turns as a whole turns every hair with it.
TEST(CurvedScalp, TurnsWithTheHead) {
  const Matrix3d turn = some_turn(1.1);
  const Vector3d way(0.3, -0.2, 0.5);
  std::array<Lock, 3> locks, turned;
  for (int k = 0; k < 3; ++k) {
    locks[k] = lock(root_of(Vector3d(0.1 * k, 0.2, 0), some_turn(0.2 * k)), curl(7, 0.2, 0.3, 1, 2 * k));
    turned[k] = locks[k];
    turned[k].root = {turn * locks[k].root.position + way, turn * locks[k].root.axis,
                      turn * locks[k].root.side};
    for (Eigen::Index at = 0; at < locks[k].points.size(); at += 3)
      turned[k].points.segment<3>(at) = turn * locks[k].points.segment<3>(at) + way;
  }
  const RootFrame root = root_of(Vector3d(0.1, 0.1, 0), some_turn(0.3));
  const Weights weights{0.2, 0.3, 0.5};
  VectorXd expected = interpolated(locks, weights, root);
  for (Eigen::Index at = 0; at < expected.size(); at += 3)
    expected.segment<3>(at) = turn * expected.segment<3>(at) + way;
  expect_all(interpolated(turned, weights, {turn * root.position + way, turn * root.axis, turn * root.side}),
             expected, "a strand between guides on a head that was turned and moved");
}

// Curls that are out of step cancel each other, as the pictures show.
TEST(FlatScalp, OfCurlsOutOfStepHasNoCurl) {
  const RootFrame root{Vector3d::Zero(), Vector3d(0, 0, 1), Vector3d(1, 0, 0)};
  std::array<Lock, 3> locks;
  for (int k = 0; k < 3; ++k) locks[k] = lock(root, curl(13, 0.5, 0.3, 3, 2 * kPi * k / 3));
  expect_all(interpolated(locks, {1.0 / 3, 1.0 / 3, 1.0 / 3}, root), line(13, Vector3d(0, 0, 0.9)),
             "the mean of three curls that are a third of a turn apart: a straight line");
}

// A strand of a nanometre is one of a metre.
TEST(Units, InAnyUnitByInterpolate) {
  const double unit = 0x1p-90;
  std::array<Lock, 3> locks, small;
  for (int k = 0; k < 3; ++k) {
    locks[k] = lock(root_of(Vector3d(k, 1, 0), some_turn(k)), curl(9, 0.5, 0.3, 1.5, k));
    small[k] = locks[k];
    small[k].points *= unit;
    small[k].root.position *= unit;
  }
  RootFrame root = root_of(Vector3d(1, 2, 0), some_turn(0.3));
  const Weights weights{0.2, 0.3, 0.5};
  const VectorXd expected = interpolated(locks, weights, root);
  root.position *= unit;
  expect_all(interpolated(small, weights, root) / unit, expected,
             "a strand between guides, all lengths times 2^-90, in that unit");
}

// ---- (3)

TEST(Arcs, MeasuresTheLength) {
  const Lock guide = upright(vector({1, 1, 1, 1, 1, 2, 1, 4, 6, 1, 4, 0}));
  expect_numbers(carried(guide).arc, Eigen::Vector4d(0, 1.0 / 12, 0.5, 1), 1e-12,
                 "arc of a guide with segments of 1, 5 and 6 m");
}

TEST(CarriedTurns, TurnsNothingAlongAStraightGuide) {
  const RootFrame root = root_of(Vector3d(1, 2, 3), some_turn());
  const GuideFrames frames = carried(lock(root, line(6, Vector3d(0, 0, 2))));
  for (const Matrix3d& turn : frames.turns)
    expect_matrix(turn, Matrix3d::Identity(), 1e-12,
                  "a turn along a guide that leaves the scalp straight along its normal");
}

// Frames turn only as the guide turns. This one leaves the scalp sideways and then goes straight on, so its
// frames stay the root's.
TEST(CarriedTurns, BeginsWithTheFirstSegment) {
  const Lock guide{{Vector3d::Zero(), Vector3d(0, 0, 1), Vector3d(0, 1, 0)}, line(4, Vector3d(3, 0, 0))};
  for (const Matrix3d& turn : carried(guide).turns)
    expect_matrix(turn, Matrix3d::Identity(), 1e-12, "a turn along a straight guide");
}

TEST(CarriedTurns, TurnsAtABend) {
  const double bend = kPi / 3, y = 3 * std::sin(bend), z = 3 * std::cos(bend);
  const GuideFrames frames = carried(upright(vector({0, 0, 0, 0, 0, 2, 0, y, 2 + z, 0, 2 * y, 2 + 2 * z})));
  const Matrix3d expected = Eigen::AngleAxisd(-bend, Vector3d::UnitX()).toRotationMatrix();
  expect_matrix(frames.turns[1], Matrix3d::Identity(), 1e-12, "the turn before the guide bends");
  expect_matrix(frames.turns[2], expected, 1e-12,
                "the turn of a guide that bends once, by 60 degrees about -x");
  expect_matrix(frames.turns[3], expected, 1e-12, "the turn after that, where it goes straight on");
}

// Around three edges of a cube: no corner twists the frame, and yet it comes back turned.
TEST(CarriedTurns, AddsUpRotations) {
  const Lock guide = upright(vector({0, 0, 0, 0, 0, 2, 2, 0, 2, 2, 2, 2, 2, 2, 4}));
  const GuideFrames frames = carried(guide);
  const Matrix3d about_y = Eigen::AngleAxisd(kPi / 2, Vector3d::UnitY()).toRotationMatrix(),
                 about_z = Eigen::AngleAxisd(kPi / 2, Vector3d::UnitZ()).toRotationMatrix(),
                 about_x = Eigen::AngleAxisd(kPi / 2, Vector3d::UnitX()).toRotationMatrix();
  const std::array<Matrix3d, 5> expected = {Matrix3d::Identity(), Matrix3d::Identity(), about_y,
                                            about_z * about_y, about_x * about_z * about_y};
  for (int i = 0; i < 5; ++i)
    expect_matrix(frames.turns[i], expected[i], 1e-12,
                  "turns[" + std::to_string(i) +
                      "] along three edges of a cube. In which order are rotations multiplied?");
}

TEST(Units, InAnyUnitByCarryAlong) {
  const Lock guide = lock(root_of(Vector3d(1, 0, 2), some_turn()), curl(12, 0.5, 0.4, 2, 1));
  const GuideFrames expected = carried(guide);
  for (const double unit : {0x1p-90, 0x1p-45, 0x1p50}) {
    Lock other = guide;
    other.points *= unit;
    const GuideFrames frames = carried(other);
    const std::string where =
        " of a curl, all lengths times " + in_powers_of_2(unit) + ", compared with the same in metres";
    expect_numbers(frames.arc, expected.arc, 1e-12, "arc" + where);
    for (std::size_t i = 0; i < 12; ++i)
      expect_matrix(frames.turns[i], expected.turns[i], 1e-10, "a turn" + where,
                    "rounding. Is a segment taken for one of length 0?");
  }
}

TEST(Folds, BeginsBehindPointsThatCoincide) {
  const Lock guide = upright(vector({0, 0, 0, 0, 0, 0, 3, 4, 0, 6, 8, 0}));
  for (const Matrix3d& turn : carried(guide).turns)
    expect_matrix(turn, Matrix3d::Identity(), 1e-12,
                  "a turn of a straight guide, whose first two points coincide: there is no direction before "
                  "the first");
}

// R_i takes one direction to the next and has its axis across both.
TEST(CarriedTurns, DoesNotTwist) {
  const Lock guide = lock(root_of(Vector3d(1, 0, 2), some_turn()), curl(30, 0.5, 0.4, 3, 1));
  const GuideFrames frames = carried(guide);
  Vector3d before = (guide.points.segment<3>(3) - guide.points.head<3>()).normalized();
  for (int i = 2; i < 30; ++i) {
    const Vector3d now = (guide.points.segment<3>(3 * i) - guide.points.segment<3>(3 * i - 3)).normalized();
    const Matrix3d R = frames.turns[i] * frames.turns[i - 1].transpose();
    expect_entries(R * before, now, 1e-10,
                   "the direction that R_" + std::to_string(i) + " takes along a curl", "the contract's");
    const Vector3d axis = before.cross(now);
    expect_entries(R * axis, axis, 1e-10,
                   "the direction across both, which R_" + std::to_string(i) + " keeps", "the contract's");
    before = now;
  }
}

// Back and forth, up to the contract's 175 degrees: R_i is the rotation about the axis across the zigzag.
TEST(Folds, TurnsSharply) {
  for (const double degrees : {120.0, 150.0, 160.0, 170.0, 174.0}) {
    const double bend = degrees * kPi / 180;
    const double y = std::sin(bend), z = 1 + std::cos(bend);
    const GuideFrames frames = carried(upright(vector({0, 0, 0, 0, 0, 1, 0, y, z, 0, y, z + 1})));
    const Matrix3d expected = Eigen::AngleAxisd(-bend, Vector3d::UnitX()).toRotationMatrix();
    expect_matrix(frames.turns[2], expected, 1e-10,
                  "the turn of a guide that turns once, by " + std::to_string(degrees) + " degrees",
                  "the contract's");
    expect_matrix(frames.turns[3], Matrix3d::Identity(), 1e-10,
                  "the turn where it has turned back, by as much", "the contract's");
  }
}

TEST(Folds, SurvivesFoldsAndPointsThatCoincide) {
  Lock guide = upright(vector({0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 0, 0, 1}));
  const GuideFrames frames = carried(guide);
  expect_matrix(frames.turns[3], Matrix3d::Identity(), 1e-12,
                "turns[3] of a guide that goes up, two points of which coincide with the points before them");
  for (int i : {4, 5}) {
    const Matrix3d& turn = frames.turns[i];
    expect_matrix(
        (turn.transpose() * turn), Matrix3d::Identity(), 1e-9,
        "turns^T turns, point " + std::to_string(i) + " of 6; after point 4 the guide turns right round",
        "the contract's");
    EXPECT_GT(turn.determinant(), 0) << "a reflection is no rotation, point " << i << " of 6";
    expect_entries(turn.col(2), Vector3d(i == 4 ? 1 : -1, 0, 0), 1e-6, "the direction that it takes along",
                   "the contract's");
  }
  guide.points.setZero();
  expect_numbers(carried(guide).arc, VectorXd::Zero(6), 0, "arc of a guide of length 0", "0");
}

// Nearer and nearer to a fold the sum of both directions is less and less than its rounding.
TEST(Folds, TurnsRightRoundWhereAGuideAllButFolds) {
  const Vector3d along = Vector3d(2, -1, 2) / 3, aside = Vector3d(1, 2, 0).normalized();
  for (const char* said : {"1e-9", "1e-12", "1e-15"}) {
    const double off = std::stod(said);
    VectorXd points(9);
    points << Vector3d::Zero(), along, off * aside;
    const Matrix3d turn = carried(upright(points)).turns[2];
    const std::string where = " of a guide that goes back beside itself, " + std::string(said) + " away";
    expect_matrix((turn.transpose() * turn), Matrix3d::Identity(), 1e-9, "turns^T turns" + where,
                  "the contract's");
    EXPECT_GT(turn.determinant(), 0) << "a reflection is no rotation" << where;
    expect_entries(turn * along, -along, 1e-6, "the direction that turns takes along" + where,
                   "1e-6: some half turn is right");
  }
}

// ---- (4)

TEST(Wisps, KeepsTheWidthOfAWisp) {
  Lock moved = upright(line(5, Vector3d(0, 0, 4)));
  for (int i = 0; i < 5; ++i) moved.points[3 * i] += 1;
  VectorXd expected = moved.points;
  for (int i = 0; i < 5; ++i) expected[3 * i + 1] += 0.5;
  expect_all(extrapolated(moved, no_turns(5), Vector3d(1, 0.5, 0), 1), expected,
             "a strand half a metre beside a straight guide, spread 1");
}

TEST(Spreading, SpreadsFromTheRootToTheTip) {
  const Lock guide = upright(line(3, Vector3d(0, 0, 2)));
  GuideFrames frames = no_turns(3);
  frames.arc[1] = 0.25;
  for (const double spread : {0.0, 1.0, 3.0}) {
    const VectorXd child = extrapolated(guide, frames, Vector3d(0.1, 0, 0), spread);
    const std::string of = ", spread " + std::to_string(spread);
    expect_point(child.head<3>(), Vector3d(0.1, 0, 0), "the root of a strand of a wisp" + of);
    expect_point(child.segment<3>(3), Vector3d(0.1 * (1 + 0.25 * (spread - 1)), 0, 1),
                 "its point at a quarter of the length" + of);
    expect_point(child.tail<3>(), Vector3d(0.1 * spread, 0, 2), "its tip" + of);
  }
}

TEST(Wisps, GoesAlongWithTheFrames) {
  const Lock guide = upright(line(3, Vector3d(0, 0, 2)));
  GuideFrames frames = no_turns(3);
  frames.turns[1] = some_turn(0.5);
  frames.turns[2] = some_turn(1);
  const Vector3d between(0.1, 0.2, -0.1);
  const VectorXd child = extrapolated(guide, frames, between, 1);
  for (int i = 0; i < 3; ++i)
    expect_point(
        child.segment<3>(3 * i), Vector3d(0, 0, i) + frames.turns[i] * between,
        "point " + std::to_string(i) + " of a wisp's strand: the difference of the roots, turned by turns_i");
}

// A strand beside a curl keeps the distance that it has at the root, and curls, too.
TEST(Wisps, KeepsCurls) {
  const Lock guide =
      lock({Vector3d(1, 1, 1), Vector3d(0, 0, -1), Vector3d(1, 0, 0)}, curl(60, 0.5, 0.4, 4, 1));
  const GuideFrames frames = carried(guide);
  const Vector3d between(0.03, 0.04, 0);
  const VectorXd child = extrapolated(guide, frames, guide.root.position + between, 1);
  double least = 1e3, most = 0;
  const Vector3d middle = guide.root.position + Vector3d(-0.5 * std::cos(1.0), 0.5 * std::sin(1.0), 0);
  for (int i = 0; i < 60; ++i) {
    EXPECT_NUMBER((child.segment<3>(3 * i) - guide.points.segment<3>(3 * i)).norm(), 0.05, 1e-12)
        << "the distance of point " << i << " from the guide's, with carry_along's turns";
    const double radius = (child.segment<3>(3 * i) - middle).head<2>().norm();
    least = std::min(least, radius);
    most = std::max(most, radius);
  }
  EXPECT_GE(least, 0.45) << "the curl's radius, of a strand 0.05 m beside a guide with a radius of 0.5 m";
  EXPECT_LE(most, 0.55) << "the curl's radius, of a strand 0.05 m beside a guide with a radius of 0.5 m";
}

TEST(Units, InAnyUnitByExtrapolate) {
  const double unit = 0x1p-90;
  Lock guide = lock(root_of(Vector3d(1, 0, 2), some_turn()), curl(12, 0.5, 0.4, 2, 1));
  const GuideFrames frames = carried(guide);
  const Vector3d root = guide.root.position + Vector3d(0.03, 0.04, 0);
  const VectorXd expected = extrapolated(guide, frames, root, 1.5);
  guide.points *= unit;
  expect_all(extrapolated(guide, frames, unit * root, 1.5) / unit, expected,
             "a strand beside a curl, all lengths times 2^-90, in that unit");
}

// ---- (5)

TEST(Blends, BeginsAsOneAndEndsAsTheOther) {
  const VectorXd at_root = scattered_vector(15, 3), at_tip = scattered_vector(15, 4);
  const VectorXd arc = vector({0, 0.1, 0.5, 0.8, 1});
  VectorXd child = VectorXd::Constant(15, 1e3);
  hair::blend(arc, at_root, at_tip, child);
  const double weights[] = {0, 0.028, 0.5, 0.896, 1};
  for (int i = 0; i < 5; ++i)
    expect_point(child.segment<3>(3 * i),
                 (1 - weights[i]) * at_root.segment<3>(3 * i) + weights[i] * at_tip.segment<3>(3 * i),
                 "point " + std::to_string(i) + " of a blend, arc parameter " + std::to_string(arc[i]) +
                     ", at_tip's weight " + std::to_string(weights[i]));
}

TEST(Units, InAnyUnitByBlend) {
  const VectorXd arc = VectorXd::LinSpaced(6, 0, 1), one = scattered_vector(18, 1),
                 other = scattered_vector(18, 2);
  VectorXd expected(18), small(18);
  hair::blend(arc, one, other, expected);
  hair::blend(arc, one * 0x1p-90, other * 0x1p-90, small);
  expect_all(small * 0x1p90, expected, "a blend, all lengths times 2^-90, in that unit");
}

TEST(Blends, MayGoWhereItComesFrom) {
  const VectorXd arc = VectorXd::LinSpaced(6, 0, 1);
  const VectorXd one = scattered_vector(18, 1), other = scattered_vector(18, 2);
  VectorXd expected(18), child = one;
  hair::blend(arc, one, other, expected);
  hair::blend(arc, child, other, child);
  expect_all(child, expected, "a blend over its first strand");
  child = other;
  hair::blend(arc, one, child, child);
  expect_all(child, expected, "a blend over its second strand");
}

int main(int argc, char** argv) {
  static const VectorXd points = VectorXd::LinSpaced(6, 0, 1), arc = VectorXd::LinSpaced(2, 0, 1);
  static VectorXd child = points;
  static GuideFrames frames{arc, std::vector<Matrix3d>(2, Matrix3d::Identity())};
  static const GuideHair guide{{}, {points.data(), points.size()}};
  return run(
      argc, argv,
      {{"root_weights", [] { hair::root_weights(kTriangle, Vector3d::Zero()); }},
       {"interpolate",
        [] {
          hair::interpolate({guide, guide, guide}, {1, 0, 0}, {}, child);
        }},
       {"carry_along", [] { carry_along(points, frames); }},
       {"extrapolate", [] { extrapolate(points, frames, Vector3d::Zero(), 1, child); }, {"carry_along"}},
       {"blend", [] { hair::blend(arc, points, points, child); }}});
}

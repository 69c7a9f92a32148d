// STAFF ONLY. H10's strands. Bounds: the contract's. A point is a sum of at most 30 products of three
// factors, which are coordinates and rotations: 1e-14 of them. Turns are 60 rotations; each rounds by 1e-16
// over one plus the cosine of its angle, at least 1/2 here.
#include <algorithm>
#include <cmath>

#include "reference/H10/answers.h"

namespace grader::h10 {
namespace {

constexpr double kPoints = 1e-12, kArcs = 1e-12, kTurns = 1e-10, kFolded = 1e-6, kRotation = 1e-9;

double difference(const std::vector<Matrix3d>& a, const std::vector<Matrix3d>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double error = (a[i] - b[i]).norm();
    if (!(error <= most)) most = error;
    if (std::isnan(most)) break;
  }
  return most;
}

void expect_turns(Trial& trial, const std::vector<Matrix3d>& answered, const std::vector<Matrix3d>& expected,
                  double bound, const std::string& what) {
  const auto entries = [](const std::vector<Matrix3d>& turns) -> VectorXd {
    return Eigen::Map<const VectorXd>(turns[0].data(), 9 * static_cast<Eigen::Index>(turns.size()));
  };
  trial.expect_at_most(difference(answered, expected), bound, what,
                       {entries(answered), entries(expected), 9});
}

void expect_points(Trial& trial, const VectorXd& answered, const VectorXd& expected, double size) {
  trial.expect_near({answered, expected}, kPoints * size, "the error of a point");
}

Weights some_weights(Random& random, int repeat) {
  if (repeat == 0) return {0, 1, 0};
  Weights weights{random.uniform(0.1), random.uniform(0.1), repeat == 1 ? 0 : random.uniform(0.1)};
  const double sum = weights[0] + weights[1] + weights[2];
  for (double& weight : weights) weight /= sum;
  return weights;
}

// `turn` is the angle between the frames of guides and child.
void expect_interpolation(Trial& trial, double turn) {
  Random& random = trial.random;
  int repeat = 0;
  for (const int n : {2, 5, 16, 16, 40}) {
    const RootFrame root = some_root(random);
    std::array<OwnGuide, 3> guides;
    double size = root.position.norm();
    for (OwnGuide& guide : guides) {
      guide = some_guide(random, n, 0.7);
      RootFrame here = moved_root(random, root, turn);
      // The guide moves to its new root.
      const Vector3d way = here.position - guide.root.position;
      for (int i = 0; i < n; ++i) guide.points.segment<3>(3 * i) += way;
      here.position = guide.points.head<3>();
      guide.root = here;
      size += guide.points.cwiseAbs().maxCoeff();
    }
    const Weights weights = some_weights(random, repeat++);
    VectorXd expected(3 * n);
    hair::interpolate({guides[0].view(), guides[1].view(), guides[2].view()}, weights, root, expected);
    expect_points(trial, ask_interpolated(trial, guides, weights, root), expected, size);
  }
}

void expect_wisp(Trial& trial, const OwnGuide& guide, double spread) {
  const GuideFrames frames = reference_frames(guide.points);
  const RootFrame root = moved_root(trial.random, guide.root, 0);
  VectorXd expected(guide.points.size());
  hair::extrapolate(guide.points, frames, root.position, spread, expected);
  expect_points(trial, ask_extrapolated(trial, guide.points, frames, root.position, spread), expected,
                guide.points.cwiseAbs().maxCoeff() + root.position.norm() * (1 + spread));
}

void expect_frames(Trial& trial, const OwnGuide& guide) {
  expect_turns(trial, ask_frames(trial, guide.points).turns, reference_frames(guide.points).turns, kTurns,
               "the error of a turn");
}

void copy_point(OwnGuide& guide, int from, int to) {
  guide.points.segment<3>(3 * to) = Vector3d(guide.points.segment<3>(3 * from));
}

// If the guide turns right round, any rotation is right that takes the direction along.
void expect_any_turns(Trial& trial, const OwnGuide& guide) {
  const std::vector<Matrix3d> turns = ask_frames(trial, guide.points).turns;
  const auto direction = [&](std::size_t i) -> Vector3d {
    const auto at = static_cast<Eigen::Index>(3 * i);
    return (guide.points.segment<3>(at) - guide.points.segment<3>(at - 3)).normalized();
  };
  for (std::size_t i = 0; i < turns.size(); ++i) {
    trial.expect_at_most((turns[i].transpose() * turns[i] - Matrix3d::Identity()).norm(), kRotation,
                         "by how much a turn is no rotation");
    trial.expect(turns[i].determinant() > 0, "a turn is a reflection");
    trial.expect_at_most((turns[i] * direction(1) - direction(std::max<std::size_t>(i, 1))).norm(), kFolded,
                         "the error of the direction that a turn takes along");
  }
}

}  // namespace

void flat_scalp(Trial& trial) {
  expect_interpolation(trial, 0);
}

void curved_scalp(Trial& trial) {
  expect_interpolation(trial, 0.5);
  expect_interpolation(trial, 2);
}

void arcs(Trial& trial) {
  for (const int n : {2, 3, 16, 60}) {
    const OwnGuide guide = some_guide(trial.random, n, 1);
    trial.expect_near({ask_frames(trial, guide.points).arc, reference_frames(guide.points).arc, 1}, kArcs,
                      "the error of an arc parameter");
  }
}

void carried_turns(Trial& trial) {
  for (const int n : {2, 3, 16, 60})
    for (const double turn : {0.3, 2.0}) expect_frames(trial, some_guide(trial.random, n, turn));
  expect_frames(trial, straight_guide(trial.random, 10));
}

void folds(Trial& trial) {
  Random& random = trial.random;
  for (const int at : {1, 4, 5, 9}) {  // a point that coincides with the one before it
    OwnGuide guide = some_guide(random, 10, 1);
    copy_point(guide, at - 1, at);
    if (at == 5) copy_point(guide, at, at + 1);
    expect_frames(trial, guide);
  }
  for (const int at : {2, 5, 9}) {  // a guide that goes back the way that it came
    OwnGuide guide = some_guide(random, 10, 1);
    copy_point(guide, at - 2, at);
    expect_any_turns(trial, guide);
  }
  // The guide goes back by a part of the way, so the sum of both directions is only rounding.
  for (int repeat = 0; repeat < 8; ++repeat) {
    OwnGuide guide = some_guide(random, 3, 1);
    const Vector3d end = guide.points.segment<3>(3), way = end - guide.points.head<3>();
    guide.points.tail<3>() = end - random.uniform(0.3, 0.9) * way;
    expect_any_turns(trial, guide);
  }
  // The guide turns nearly right round, up to the contract's 175 degrees.
  for (int repeat = 0; repeat < 4; ++repeat) expect_frames(trial, some_guide(random, 16, 3.05));
  OwnGuide point = some_guide(random, 3, 1);
  for (int i = 1; i < 3; ++i) copy_point(point, 0, i);
  expect_frames(trial, point);
  trial.expect_near({ask_frames(trial, point.points).arc, VectorXd::Zero(3), 1}, 0,
                    "an arc parameter of a guide of length 0");
}

void wisps(Trial& trial) {
  for (const int n : {2, 5, 16, 60}) expect_wisp(trial, some_guide(trial.random, n, 1), 1);
}

// Guides are straight here, so nothing turns.
void spreading(Trial& trial) {
  for (const double spread : {0.0, 0.4, 2.5})
    for (const int n : {2, 16}) expect_wisp(trial, straight_guide(trial.random, n), spread);
}

void blends(Trial& trial) {
  Random& random = trial.random;
  for (const int n : {2, 5, 16, 40})
    for (const Place place : {Place::own, Place::at_root, Place::at_tip}) {
      const OwnGuide one = some_guide(random, n, 1), other = some_guide(random, n, 1);
      const VectorXd arc = reference_frames(one.points).arc;
      VectorXd expected(3 * n);
      hair::blend(arc, one.points, other.points, expected);
      expect_points(trial, ask_blended(trial, arc, one.points, other.points, place), expected,
                    one.points.cwiseAbs().maxCoeff() + other.points.cwiseAbs().maxCoeff());
    }
}

// Compares answers in other units with the student's own answers for metres: no length is too short.
void units(Trial& trial) {
  weights_in_other_units(trial);
  Random& random = trial.random;
  for (const double unit : {0x1p-80, 0x1p-30, 0x1p40}) {
    std::array<OwnGuide, 3> guides;
    for (OwnGuide& guide : guides) guide = some_guide(random, 16, 1);
    std::array<OwnGuide, 3> there = guides;
    for (OwnGuide& guide : there) {
      guide.points *= unit;
      guide.root.position *= unit;
    }
    // Braces ask in their order, whichever compiler made the suite.
    const auto expect_same = [&](const Compared& both, double size) {
      trial.expect(both.expected.cwiseAbs().maxCoeff() > 0, "a strand is a point");
      expect_points(trial, both.actual / unit, both.expected, 2 * size);
    };
    const VectorXd &one = guides[0].points, &other = guides[1].points;
    double size = 0;
    for (const OwnGuide& guide : guides) size += guide.points.cwiseAbs().maxCoeff();

    const GuideFrames frames = ask_frames(trial, one), same = ask_frames(trial, there[0].points);
    trial.expect_near({same.arc, frames.arc, 1}, 2 * kArcs,
                      "by how much an arc parameter changes with the unit");
    expect_turns(trial, same.turns, frames.turns, 2 * kTurns, "by how much a turn changes with the unit");

    RootFrame root = moved_root(random, guides[0].root, 0.5);
    const Vector3d position = root.position;
    const Weights weights = some_weights(random, 2);
    const VectorXd between = ask_interpolated(trial, guides, weights, root);
    root.position *= unit;
    expect_same({ask_interpolated(trial, there, weights, root), between}, size + position.norm());

    const GuideFrames ours = reference_frames(one);
    expect_same({ask_extrapolated(trial, there[0].points, ours, unit * position, 1.5),
                 ask_extrapolated(trial, one, ours, position, 1.5)},
                size + 2.5 * position.norm());
    expect_same({ask_blended(trial, ours.arc, there[0].points, there[1].points, Place::own),
                 ask_blended(trial, ours.arc, one, other, Place::own)},
                size);
  }
}

}  // namespace grader::h10

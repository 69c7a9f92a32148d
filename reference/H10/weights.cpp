// STAFF ONLY. H10's weights. Bounds: the contract's. Weights from areas are right to 1e-16 of an edge over
// the height, a hundredth of it here: 1e-14.
#include <algorithm>

#include "reference/H10/answers.h"

namespace grader::h10 {
namespace {

constexpr double kSum = 1e-12, kPoint = 1e-10, kThin = 1e-6;

Vector3d point_of(const Corners& corners, const Weights& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

Compared beside_ours(const Weights& weights, const Corners& corners, const Vector3d& root, double bound) {
  const Weights ours = hair::root_weights(corners, root);
  return {Vector3d(weights.data()), Vector3d(ours.data()), 1, {}, bound};
}

Weights checked_weights(Trial& trial, const Corners& corners, const Vector3d& root, double bound) {
  const Weights weights = ask_weights(trial, corners, root);
  trial.expect_at_most(std::abs(weights[0] + weights[1] + weights[2] - 1), bound,
                       "the sum of the weights, less 1,", beside_ours(weights, corners, root, bound));
  trial.expect(
      *std::min_element(weights.begin(), weights.end()) >= 0, "a weight is negative",
      std::to_string(weights[0]) + ", " + std::to_string(weights[1]) + ", " + std::to_string(weights[2]));
  return weights;
}

void expect_nearest(Trial& trial, const Corners& corners, const Vector3d& root) {
  const Weights weights = checked_weights(trial, corners, root, kSum);
  const Vector3d expected = point_of(corners, hair::root_weights(corners, root)),
                 answered = point_of(corners, weights);
  trial.expect_at_most((answered - expected).norm(), kPoint * longest_edge(corners),
                       "the distance from the triangle's nearest point",
                       beside_ours(weights, corners, root, kPoint));
}

Vector3d normal_of(const Corners& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
}

}  // namespace

void weights_inside(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 12; ++repeat) {
    const Corners corners = some_triangle(random, random.log_uniform(0.012, 0.9));
    Weights inside{random.uniform(0.05), random.uniform(0.05), random.uniform(0.05)};
    const double sum = inside[0] + inside[1] + inside[2];
    for (double& weight : inside) weight /= sum;
    const double above = repeat % 3 == 0 ? 0 : random.uniform(-0.5, 0.5) * longest_edge(corners);
    const Vector3d root = point_of(corners, inside) + above * normal_of(corners);
    trial.describe("a root over the inside of a triangle");
    expect_nearest(trial, corners, root);
  }
}

// Roots are beside each edge and beyond each corner. In most places weights that are cut off at 0 are not
// those of the nearest point.
void weights_outside(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 24; ++repeat) {
    const Corners corners = some_triangle(random, random.uniform(0.05, 0.9));
    const int k = repeat % 3, next = (k + 1) % 3;
    const Vector3d middle = point_of(corners, {1.0 / 3, 1.0 / 3, 1.0 / 3});
    const double size = longest_edge(corners);
    const double far = random.uniform(0.3, 3) * size;
    Vector3d root = far * some_direction(random);
    if (repeat % 2 == 0) {
      const double part = random.uniform();
      const Vector3d on_edge = (1 - part) * corners[k] + part * corners[next];
      root += on_edge + random.uniform(0.1, 2) * (on_edge - middle);
    } else {
      root += corners[k] + random.uniform(0.1, 2) * (corners[k] - middle);
    }
    // Moves the root back into the plane, or near it; without this many roots would be far above it.
    const Vector3d normal = normal_of(corners);
    root -= random.uniform(0.9, 1) * normal.dot(root - corners[0]) * normal;
    const Weights nearest = hair::root_weights(corners, root);
    if (*std::min_element(nearest.begin(), nearest.end()) > 0) continue;  // over the inside after all
    trial.describe("a root beside a triangle");
    expect_nearest(trial, corners, root);
  }
}

namespace {

// The corners are on a line, two of them a millionth of its length apart. The area is only rounding.
void needles(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 60; ++repeat) {
    Corners corners = some_triangle(random, 0);
    const Vector3d first = corners[repeat % 3], last = corners[(repeat + 2) % 3];
    corners[(repeat + 1) % 3] = first + 1e-6 * (last - first);
    const Vector3d root = first + random.uniform() * (last - first);
    trial.describe("three roots on a line, two of them side by side");
    trial.expect_at_most((point_of(corners, checked_weights(trial, corners, root, kThin)) - root).norm(),
                         kThin * longest_edge(corners), "how much farther than the nearest point it is");
  }
}

Vector3d some_point_of(Random& random, const Corners& corners) {
  Weights at{random.uniform(), random.uniform(), random.uniform()};
  const double sum = at[0] + at[1] + at[2];
  for (double& weight : at) weight /= sum;
  return point_of(corners, at);
}

// The weights of a thin triangle are not unique, but the distance is.
void expect_near(Trial& trial, const Corners& corners, const Vector3d& root) {
  const double least = (point_of(corners, hair::root_weights(corners, root)) - root).norm(),
               distance = (point_of(corners, checked_weights(trial, corners, root, kThin)) - root).norm();
  trial.expect_at_most(distance - least, kThin * longest_edge(corners),
                       "how much farther than the nearest point it is");
}

}  // namespace

// Triangles are far thinner than long, and the root is over the inside.
void thin_triangles(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 12; ++repeat) {
    const Corners corners = some_triangle(random, repeat % 2 == 0 ? 1e-3 : 1e-4);
    const double height = repeat % 4 < 2 ? 0 : random.uniform(0, 1) * longest_edge(corners);
    const Vector3d above = height * normal_of(corners);
    trial.describe("a thin triangle");
    expect_near(trial, corners, some_point_of(random, corners) + above);
  }
}

// The corners are on a line up to rounding, or in one place, and the root is anywhere.
void no_width(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 24; ++repeat) {
    const int kind = repeat % 4;
    Corners corners = some_triangle(random, kind == 0 ? 1e-9 : 0);
    const double size = longest_edge(corners);
    if (kind == 2) corners[repeat % 3] = corners[(repeat + 1) % 3];
    if (kind == 3) corners[1] = corners[2] = corners[0];
    const double far = (repeat % 2) * random.uniform(0, 1) * size;
    const Vector3d beside = far * some_direction(random);
    trial.describe("three roots on a line, or in one place");
    expect_near(trial, corners, some_point_of(random, corners) + beside);
  }
  needles(trial);
}

// Compares triangles of any form in smaller and larger units with the student's own answers for metres. No
// triangle is thin because of its size.
void weights_in_other_units(Trial& trial) {
  Random& random = trial.random;
  for (int repeat = 0; repeat < 8; ++repeat) {
    const int kind = repeat / 2;  // once over the triangle, once beside it
    Corners corners = some_triangle(random, kind == 0 ? 1e-3 : random.uniform(0.1, 0.9));
    Vector3d root = some_point_of(random, corners);
    root += (repeat % 2) * longest_edge(corners) * some_direction(random);
    trial.describe("a triangle in another unit");
    const Vector3d expected = point_of(corners, ask_weights(trial, corners, root));
    const double size = longest_edge(corners),
                 unit = kind < 2    ? 0x1p-80
                        : kind == 2 ? 0x1p-30
                                    : 0x1p40,
                 bound = kind == 0 ? kThin : kPoint;
    for (Vector3d* point : {&corners[0], &corners[1], &corners[2], &root}) *point *= unit;
    const Vector3d answered = point_of(corners, ask_weights(trial, corners, root)) / unit;
    trial.expect_at_most((answered - expected).norm(), 2 * bound * size,
                         "by how much the nearest point moves in another unit");
  }
}

}  // namespace grader::h10

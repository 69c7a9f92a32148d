// Ordinary inputs: these checks, and those of grading, use them unless they are about a special value. No
// number is 1, no two are equal, nothing grows evenly, and no direction lies along an axis. So a missing
// factor, or a neighbour's value, changes the answer.
//
// Numbers come from a `source`: a Scatter here, the secret's source in grading. Each statement draws once,
// since compilers evaluate two draws of one expression in either order.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "hair/strand.h"
#include "particles/state.h"

namespace checks {

// The same numbers for the same `which`, on every machine.
class Scatter {
 public:
  explicit Scatter(int which) : state_(2654435769U * static_cast<std::uint32_t>(which + 1)) {}

  double uniform(double low, double high) {
    state_ = 1664525 * state_ + 1013904223;
    return low + (high - low) * (state_ / 4294967296.0);
  }

 private:
  std::uint32_t state_;
};

// A number that is at least a twentieth of `high - low` away from 1 and from `other`.
template <class Source>
double ordinary_number(Source& source, double low, double high, double other = 1) {
  const double apart = (high - low) / 20;
  double value = source.uniform(low, high);
  while (std::abs(value - 1) < apart || std::abs(value - other) < apart) value = source.uniform(low, high);
  return value;
}

// Numbers of which neighbours differ, too.
template <class Source>
Eigen::VectorXd ordinary_numbers(Source& source, int count, double low, double high) {
  Eigen::VectorXd values(count);
  for (int i = 0; i < count; ++i) values[i] = ordinary_number(source, low, high, i > 0 ? values[i - 1] : 1);
  return values;
}

// A vector of length 1. No two components have the same absolute value, and none is near 0 or 1.
template <class Source>
Eigen::Vector3d ordinary_direction(Source& source) {
  for (;;) {
    Eigen::Vector3d u;
    for (double& entry : u) entry = source.uniform(-1, 1);
    const Eigen::Array3d size = u.array().abs() / u.norm();
    const double nearest = (size - Eigen::Array3d(size[1], size[2], size[0])).abs().minCoeff();
    if (size.minCoeff() > 0.1 && nearest > 0.1) return u.normalized();
  }
}

// Particles that are all free.
template <class Source>
particles::Particles ordinary_particles(Source& source, int count) {
  return {ordinary_numbers(source, count, 0.4, 3), std::vector<char>(static_cast<std::size_t>(count), 0)};
}

template <class Source>
particles::State ordinary_state(Source& source, int count) {
  Eigen::VectorXd x = ordinary_numbers(source, 3 * count, -2, 2);
  return {std::move(x), ordinary_numbers(source, 3 * count, -2, 2)};
}

// A strand with ordinary masses, rest lengths and rigidities. Its root tangent lies along no axis, clamped or
// not.
template <class Source>
hair::Strand ordinary_strand(Source& source, int count) {
  hair::Strand strand;
  strand.mass = ordinary_numbers(source, count, 0.4, 3);
  strand.rest_length = ordinary_numbers(source, count - 1, 0.3, 2.3);
  strand.stretch_rigidity = ordinary_number(source, 20, 90);
  strand.bend_rigidity = ordinary_number(source, 3, 9);
  strand.skip_rigidity = ordinary_number(source, 10, 40);
  strand.root_tangent = ordinary_direction(source);
  return strand;
}

// Positions of a strand whose segments are as long as at rest, times `shortest` to `longest`. Each leaves the
// direction of the one before by up to `bend`, over its length; the root is anywhere.
template <class Source>
Eigen::VectorXd ordinary_positions(Source& source, const hair::Strand& strand, double shortest,
                                   double longest, double bend) {
  Eigen::VectorXd x(3 * strand.count());
  for (int i = 0; i < 3; ++i) x[i] = source.uniform(-2, 2);
  Eigen::Vector3d direction = strand.clamped ? strand.root_tangent : ordinary_direction(source);
  for (int i = 0; i < strand.segments(); ++i) {
    if (i > 0 || strand.clamped) {
      const Eigen::Vector3d turn = ordinary_direction(source);
      direction = (direction + bend * turn).normalized();
    }
    const double stretch = source.uniform(shortest, longest);
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + stretch * strand.rest_length[i] * direction;
  }
  return x;
}

}  // namespace checks

// Rigid motion by key frames: of a head, a hand, the roots of hair.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "particles/vectors.h"

namespace hair {

using Eigen::Vector3d;

// x -> rotation x + position.
struct Pose {
  Vector3d position = Vector3d::Zero();  // m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

struct Key {
  double time;  // s
  Pose pose;
};

// At least one key, at increasing times. The pose is constant before the first key and after the last.
struct Motion {
  std::vector<Key> keys;

  // Between two keys it speeds up and slows down smoothly: after a fraction s of the time it has covered 3
  // s^2 - 2 s^3 of the way, and it is at rest at each key.
  Pose at(double time) const;
};

// A pose relative to a motion's first: x -> rotation (x - from) + to, for a position x at the first key.
struct Way {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();

  Vector3d operator()(const Vector3d& x) const { return rotation * (x - from) + to; }
};

// x -> after(before(x)).
inline Way operator*(const Way& after, const Way& before) {
  return {after.rotation * before.rotation, before.from, after(before.to)};
}

Way way_at(const Motion& motion, double time);
bool turns(const Motion& motion);

}  // namespace hair

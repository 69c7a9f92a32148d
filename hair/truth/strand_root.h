// The root of a problem's strand: it keeps its velocity, or follows a motion.
#pragma once

#include <vector>

#include "hair/scene/scene.h"

namespace hair {

struct RootMotion {
  Vector3d position, velocity, acceleration;  // m, m/s, m/s^2
  Vector3d tangent, normal;                   // unit vectors
};

class StrandRoot {
 public:
  // Keeps a reference to the scene, which has one strand.
  explicit StrandRoot(const Scene& scene);

  // True if tangent and normal change with time.
  bool turns() const { return turns_; }

  // The times of a motion's keys, at which the acceleration jumps. at() is valid between two of them: from
  // `time` to the next one after start_span(time), and before the first one initially.
  std::vector<double> breaks() const;
  void start_span(double time);

  RootMotion at(double time) const;

 private:
  RootMotion start_;                // its state before it moves
  const Motion* motion_ = nullptr;  // null: the root follows no motion
  bool turns_ = false;
  std::size_t next_key_ = 0;  // at the end of the span; motion_->keys.size() in the last span
};

}  // namespace hair

// Where the root of a problem's strand is: it goes on with the velocity that it has, or as what it rides on does.
#pragma once

#include <vector>

#include "hair/scene/scene.h"

namespace hair {

struct RootMotion {
  Vector3d position, velocity, acceleration;  // m, m/s, m/s^2
  Vector3d tangent, normal;                   // of length 1
};

class StrandRoot {
 public:
  // Refers to the scene, which has one strand.
  explicit StrandRoot(const Scene& scene);

  // Tangent and normal move: what holds on to them must know.
  bool turns() const { return turns_; }

  // The times at which it speeds up or slows down at once: a motion's keys. What at() says holds between two of them:
  // from `time` on until the next, once it was told start_span(time), and from before the first at the start.
  std::vector<double> breaks() const;
  void start_span(double time);

  RootMotion at(double time) const;

 private:
  const StrandStart& start_;
  const Motion* motion_ = nullptr;  // none: nothing that it rides on
  bool turns_ = false;
  std::size_t next_key_ = 0;  // that the span ends with; motion_->keys.size() in the last
};

}  // namespace hair

// Moves riders during a step: roots and obstacles get the velocity that brings them from their present
// position to that of their motion at the step's end, so that errors never sum up.
#pragma once

#include <vector>

#include "hair/scene/scene.h"
#include "hair/simulation/simulation.h"

namespace hair {

// The reference point of an obstacle: a plane's point, a sphere's centre, a capsule's first end, a placed
// solid's origin.
Vector3d place_of(const Obstacle& obstacle);

class Riding {
 public:
  // Throws std::invalid_argument for a missing strand or obstacle, for keys whose times don't increase, and
  // for a plane or capsule on a motion that turns: these only translate.
  Riding(const Rider& rider, const Description& hair);

  // Call it before the step from `time` to time + h. A hand leads the riders, too: beyond their motion, from
  // `held` at the step's beginning to `hand` at its end.
  void lead(Simulation& simulation, double time, double h, const Way& held, const Way& hand) const;

 private:
  struct LedRoot {
    int strand;
    Vector3d position, tangent, normal;  // before the motion's first key
  };
  struct LedObstacle {
    int obstacle;
    Vector3d place;
    Eigen::Quaterniond rotation;  // only for a placed solid
  };

  static LedRoot root_of(const Description& hair, int strand);

  Motion motion_;
  bool turns_;
  std::vector<LedRoot> roots_;
  std::vector<LedObstacle> obstacles_;
};

}  // namespace hair

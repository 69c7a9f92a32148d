// How riders are led through a step: roots and obstacles get the velocity that brings them where their motion
// is at the step's end, from where they are, so that errors never sum up.
#pragma once

#include <vector>

#include "hair/scene/scene.h"
#include "hair/simulation/simulation.h"

namespace hair {

// The point that an obstacle's place is told by: a point of its plane, its centre, its first end.
Vector3d place_of(const Obstacle& obstacle);

class Riding {
 public:
  // Throws std::invalid_argument for a strand or an obstacle that is not there, keys that don't come one
  // after the other, and a plane or capsule on a motion that turns: an obstacle moves, and does not turn.
  Riding(const Rider& rider, const Description& hair);

  // Before the step from `time` to time + h.
  void lead(Simulation& simulation, double time, double h) const;

 private:
  struct LedRoot {
    int strand;
    Vector3d position, tangent, normal;  // before the motion's first key
  };
  struct LedObstacle {
    int obstacle;
    Vector3d place;
  };

  static LedRoot root_of(const Description& hair, int strand);

  Motion motion_;
  bool turns_;
  std::vector<LedRoot> roots_;
  std::vector<LedObstacle> obstacles_;
};

}  // namespace hair

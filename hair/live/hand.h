// A hand that leads roots after a mouse: smoothly, and at 2 m/s at most.
#pragma once

#include "hair/scene/motion.h"

namespace hair {

inline constexpr double kFastestHand = 2;  // m/s
inline constexpr double kHandReach = 0.2;  // m; a turn counts as the way of a point at this distance

class Hand {
 public:
  explicit Hand(const Vector3d& pivot) : pivot_(pivot) {}

  // offset: m from the start; turn: rad about the vertical through the pivot. Ignores goals beyond 1000.
  void go_to(const Vector3d& offset, double turn);

  // Moves on for h seconds: a critically damped spring pulls it to its goal.
  Way after(double h);

  bool leads() const { return leads_; }  // since the first go_to

 private:
  Vector3d pivot_;
  bool leads_ = false;
  Eigen::Vector4d goal_ = Eigen::Vector4d::Zero(), at_ = Eigen::Vector4d::Zero(),
                  velocity_ = Eigen::Vector4d::Zero();  // the last one: the turn times kHandReach
};

}  // namespace hair

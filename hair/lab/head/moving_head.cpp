#include "hair/lab/head/moving_head.h"

#include <numbers>

namespace hair::head_study {

Motion turn_of_head() {
  const auto at = [](int frame, double degrees) {
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vector3d::UnitZ());
    return Key{frame / kFramesPerSecond, {Vector3d::Zero(), Eigen::Quaterniond(turn)}};
  };
  return {{at(kSettle, 0), at(kSettle + kMoving / 2, kTurn), at(kSettle + kMoving, 0)}};
}

}  // namespace hair::head_study

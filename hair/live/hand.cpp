#include "hair/live/hand.h"

#include <cmath>

namespace hair {

namespace {

constexpr double kStiffness = 25;   // 1/s, the square root of the spring's
constexpr double kFarthest = 1000;  // m, rad

}  // namespace

void Hand::go_to(const Vector3d& offset, double turn) {
  if (!(offset.norm() <= kFarthest && std::abs(turn) <= kFarthest)) return;
  leads_ = true;
  goal_ << offset, kHandReach * turn;
}

// The exact motion for h seconds, so it holds with any step.
Way Hand::after(double h) {
  const double decay = std::exp(-kStiffness * h);
  const Eigen::Vector4d away = at_ - goal_, push = velocity_ + kStiffness * away;
  const Eigen::Vector4d next = goal_ + decay * (away + h * push);
  velocity_ = decay * (velocity_ - kStiffness * h * push);
  const double way = (next - at_).norm(), most = kFastestHand * h;
  if (way > most) velocity_ = kFastestHand / way * (next - at_);
  at_ = way > most ? Eigen::Vector4d(at_ + h * velocity_) : next;
  return {Eigen::Quaterniond(Eigen::AngleAxisd(at_[3] / kHandReach, Vector3d::UnitZ())), pivot_,
          pivot_ + at_.head<3>()};
}

}  // namespace hair

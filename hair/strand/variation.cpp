#include "hair/strand/variation.h"

#include <cmath>
#include <numbers>

namespace hair {

namespace {

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

}  // namespace

Variation::Variation(std::uint64_t seed, std::uint64_t sequence)
    : state_(mixed(seed ^ mixed(sequence + 0x9e3779b97f4a7c15U))) {}

double Variation::uniform(double low, double high) {
  state_ += 0x9e3779b97f4a7c15U;
  const std::uint64_t z = mixed(state_);
  return low + (high - low) * (static_cast<double>(z >> 11) * 0x1p-53);
}

RootFrame varied(const RootFrame& frame, double tilt, double turn, Variation& variation) {
  const double towards = variation.uniform(0, 2 * std::numbers::pi);
  // Evenly over the small disc of directions.
  const double angle = tilt * std::sqrt(variation.uniform(0, 1));
  const double about = variation.uniform(-turn, turn);
  const Vector3d hinge = Eigen::AngleAxisd(towards, frame.axis) * frame.side;
  const Eigen::Quaterniond turned =
      Eigen::AngleAxisd(angle, hinge) * Eigen::Quaterniond(Eigen::AngleAxisd(about, frame.axis));
  RootFrame result{frame.position, (turned * frame.axis).normalized(), {}};
  const Vector3d side = turned * frame.side;
  result.side = (side - side.dot(result.axis) * result.axis).normalized();
  return result;
}

}  // namespace hair

#include "hair/lab/head/moving_head.h"

#include <numbers>
#include <numeric>
#include <stdexcept>

#include "solver/timing.h"

namespace hair::head_study {
namespace {

Vector3d first_direction(const Eigen::VectorXd& x) {
  return (x.segment<3>(3) - x.head<3>()).normalized();
}

// Clamped in the direction in which it leaves the head.
StrandStart start_of(const Eigen::VectorXd& x, bool curved) {
  const Vector3d tangent = first_direction(x);
  return start_at_rest(Fibre{}, {x, tangent, tangent.unitOrthogonal()}, !curved, true);
}

Scene scene_of(const GrownHead& head, std::span<const std::size_t> which,
               const MovingHeadSettings& settings) {
  Scene scene;
  scene.name = head.hair->id;
  scene.frames = kSettle + kMoving;
  scene.frames_per_second = kFramesPerSecond;
  scene.steps_per_frame = kStepsPerFrame;
  scene.hair.method = Method::implicit_euler;
  scene.hair.step = 1 / (kFramesPerSecond * kStepsPerFrame);
  scene.hair.drag = kDrag;
  scene.hair.watched = false;
  Rider rider{turn_of_head(), std::vector<int>(which.size()), {}};
  std::iota(rider.strands.begin(), rider.strands.end(), 0);
  for (const std::size_t k : which)
    scene.hair.strands.push_back(start_of(head.strands[k], head.hair->curved));
  if (settings.collides) {
    scene.hair.obstacles.push_back({PlacedSolid{settings.bust}, kFriction});
    rider.obstacles = {0};
  }
  scene.riders.push_back(std::move(rider));
  return scene;
}

}  // namespace

Motion turn_of_head() {
  const auto at = [](int frame, double degrees) {
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vector3d::UnitZ());
    return Key{frame / kFramesPerSecond, {Vector3d::Zero(), Eigen::Quaterniond(turn)}};
  };
  return {{at(kSettle, 0), at(kSettle + kMoving / 2, kTurn), at(kSettle + kMoving, 0)}};
}

MovingHead::MovingHead(const GrownHead& head, std::span<const std::size_t> which,
                       const MovingHeadSettings& settings)
    : scene_run_(scene_of(head, which, settings)) {}

double MovingHead::advance() {
  const double begin = timing::process_cpu_seconds();
  if (const auto broke = scene_run_.advance()) throw std::runtime_error("the hair broke: " + *broke);
  return timing::process_cpu_seconds() - begin;
}

std::span<const double> MovingHead::points() {
  state_ = scene_run_.state();
  return {state_.x.data(), static_cast<std::size_t>(state_.x.size())};
}

}  // namespace hair::head_study

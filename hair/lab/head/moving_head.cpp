#include "hair/lab/head/moving_head.h"

#include <numbers>
#include <numeric>
#include <stdexcept>

#include "hair/head/grow.h"
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

constexpr std::uint64_t kSeed = 1;
constexpr int kStraightPoints = 25;
// Curls are shorter than the styles that have names, so that fewer points follow the hair: m.
constexpr double kStraightLength = 0.36, kWavyLength = 0.2, kCurlyLength = 0.1;

HairStyle styled(const char* name, double length) {
  HairStyle style = *find_hair_style(name);
  style.length = length;
  return style;
}

HairStyle without_chance(HairStyle style) {
  style.varies = style.tilt = style.fly_aways = 0;
  style.clump = 0;
  return style;
}

HeadHair curved(const char* id, const char* title, const HairStyle& style) {
  return {id, title, style, fewest_points(style), true};
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

const std::vector<HeadHair>& head_hairs() {
  static const std::vector<HeadHair> all = {
      {"straight", "Straight hair", styled("long-smooth", kStraightLength), kStraightPoints, false},
      {"combed", "Straight hair, all alike", without_chance(styled("long-smooth", kStraightLength)),
       kStraightPoints, false},
      curved("wavy", "Wavy hair", styled("wavy", kWavyLength)),
      curved("curly", "Curly hair", styled("short-curly", kCurlyLength))};
  return all;
}

GrownHead grow_head(const Bust& bust, const HeadHair& hair, int strands) {
  GrownHead head{&hair, {}, grow_groom(bust, hair.style, {strands, hair.points, kSeed}).strands, 0};
  head.roots.reserve(head.strands.size());
  for (const Eigen::VectorXd& x : head.strands) {
    const Vector3d normal = bust.surface_at(x.head<3>()).normal;
    head.roots.push_back({x.head<3>(), normal, side_of(normal)});
    for (Eigen::Index k = 3; k < x.size(); k += 3)
      head.length += (x.segment<3>(k) - x.segment<3>(k - 3)).norm();
  }
  head.length /= static_cast<double>(head.strands.size());
  return head;
}

}  // namespace hair::head_study

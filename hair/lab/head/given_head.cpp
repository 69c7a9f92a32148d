#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "hair/lab/head/moving_head.h"
#include "hair/scene/playback.h"

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
  scene.hair.jobs = settings.threads;
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

class GivenHead : public MovingHead {
 public:
  explicit GivenHead(const Scene& scene) : playback_(scene) {}

  void advance() override {
    if (const auto broke = playback_.advance()) throw std::runtime_error("the hair broke: " + *broke);
  }

  void read(std::span<double> points) const override {
    const particles::State state = playback_.state();
    std::copy_n(state.x.data(), state.x.size(), points.data());
  }

 private:
  Playback playback_;
};

}  // namespace

std::unique_ptr<MovingHead> given_head(const GrownHead& head, std::span<const std::size_t> which,
                                       const MovingHeadSettings& settings) {
  return std::make_unique<GivenHead>(scene_of(head, which, settings));
}

}  // namespace hair::head_study

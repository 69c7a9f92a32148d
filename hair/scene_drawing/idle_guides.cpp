#include "hair/scene_drawing/idle_guides.h"

#include <algorithm>
#include <cmath>

#include "hair/strand/strand_spec.h"

namespace hair {

namespace {

constexpr int kPosesBetweenKeys = 16;
constexpr double kStretch = 1.5;  // times the length at rest

double length_of(const Description& hair, int strand) {
  const auto index = static_cast<std::size_t>(strand);
  return index < hair.strands.size() ? hair.strands[index].strand.rest_length.sum()
                                     : hair.modelled[index - hair.strands.size()].spec.length;
}

// The poses of a motion: at its keys, and at many times between them.
std::vector<Way> poses_of(const std::optional<Motion>& motion) {
  if (!motion) return {{Eigen::Quaterniond::Identity(), Vector3d::Zero(), Vector3d::Zero()}};
  const std::vector<Key>& keys = motion->keys;
  std::vector<Way> ways = {way_at(*motion, keys.front().time)};
  for (std::size_t k = 0; k + 1 < keys.size(); ++k)
    for (int i = 1; i <= kPosesBetweenKeys; ++i)
      ways.push_back(way_at(
          *motion, std::lerp(keys[k].time, keys[k + 1].time, static_cast<double>(i) / kPosesBetweenKeys)));
  return ways;
}

class Seen {
 public:
  Seen(const std::vector<Plane>& view, const std::optional<Motion>& motion)
      : view_(view), poses_(poses_of(motion)) {}

  // True if a ball around a point that starts at `point` comes into view.
  bool comes_into_view(const Vector3d& point, double radius) const {
    Vector3d before = poses_.front()(point);
    return std::any_of(poses_.begin(), poses_.end(), [&](const Way& pose) {
      const Vector3d here = pose(point);
      // Between two poses the ball is near one of them.
      const double reach = radius + (here - before).norm();
      before = here;
      return std::all_of(view_.begin(), view_.end(),
                         [&](const Plane& plane) { return plane.normal.dot(here - plane.point) >= -reach; });
    });
  }

 private:
  const std::vector<Plane>& view_;
  std::vector<Way> poses_;
};

// For each guide, 1 if it makes a strand that may be visible.
std::vector<char> guides_in_use(const Scene& scene, const DenseHair& dense, const Synthesis& synthesis,
                                const std::vector<Plane>& view) {
  const SynthesisDescription& made = dense.description;
  const Seen seen(view, dense.motion);
  std::vector<char> in_use(made.guides.size());
  for (int child = 0; child < synthesis.children(); ++child) {
    const Parents& parents = synthesis.parents(child);
    const Vector3d& root = made.children[static_cast<std::size_t>(child)].position;
    double longest = 0, beside = 0;
    for (const int guide : parents.guides) {
      longest = std::max(longest, length_of(scene.hair, dense.first + guide));
      beside = std::max(beside, (made.guides[static_cast<std::size_t>(guide)].position - root).norm());
    }
    const double wisp = std::max(1.0, made.spread * (1 + made.jitter)) * beside;
    const double far = kStretch * longest + wisp;
    if (!seen.comes_into_view(root, (1 + made.length) * (far + synthesis.disorder(child, far)) + beside))
      continue;
    // The nearest guide carries the strand's root.
    for (int k = 0; k < 3; ++k)
      if (k == 0 || parents.weights[k] > 0) in_use[parents.guides[k]] = 1;
  }
  return in_use;
}

}  // namespace

std::vector<int> idle_guides(const Scene& scene, const SceneDrawing& drawing) {
  std::vector<int> idle;
  if (scene.hair.mesh) return idle;
  for (std::size_t group = 0; group < scene.dense.size(); ++group) {
    const DenseHair& dense = scene.dense[group];
    const std::vector<char> in_use = guides_in_use(scene, dense, drawing.dense(group), drawing.view());
    for (std::size_t i = 0; i < in_use.size(); ++i)
      if (!in_use[i]) idle.push_back(dense.first + static_cast<int>(i));
  }
  return idle;
}

}  // namespace hair

#include "hair/linked_guides/make_control_mesh.h"

#include <algorithm>
#include <utility>

#include "hair/linked_guides/frame_torque.h"

namespace hair {
namespace {

constexpr double kShortestLink = 1e-4;  // m

class MeshMaker {
 public:
  MeshMaker(std::span<const StrandStart> guides, const MeshSpec& spec) : guides_(guides), spec_(spec) {
    int particles = 0;
    for (const StrandStart& guide : guides) {
      first_.push_back(particles);
      particles += guide.strand.count();
    }
    if (spec.strips) mesh_.law = *spec.strips;
  }

  void link(const Pair& pair) {
    const auto [one, other] = pair;
    const StrandStart& a = guides_[one];
    frames_.resize(static_cast<std::size_t>(a.strand.count()));
    guide_frames(a.state.x, a.strand.root_tangent, a.root_normal, frames_);
    for (int j = 1; j < guides_[other].strand.count(); ++j) {
      const Vector3d point = at(other, j);
      int nearest = 0;
      for (int i = 1; i < a.strand.count(); ++i)
        if ((at(one, i) - point).squaredNorm() < (at(one, nearest) - point).squaredNorm()) nearest = i;
      const Vector3d between = point - at(one, nearest);
      mesh_.links.push_back({first_[one] + nearest, first_[other] + j, frames_[nearest].transpose() * between,
                             std::max(between.norm(), kShortestLink), spec_.stiffness, spec_.yields,
                             spec_.breaks});
    }
  }

  void lay_strip(const Pair& pair) {
    const auto [one, other] = pair;
    MeshStrip strip{pair, {}};
    const int segments = std::min(guides_[one].strand.segments(), guides_[other].strand.segments());
    for (int i = 0; i < segments; ++i) {
      const int a = first_[one] + i, b = first_[other] + i;
      strip.triangles.push_back({a, b, a + 1});
      strip.triangles.push_back({b, b + 1, a + 1});
    }
    mesh_.strips.push_back(std::move(strip));
  }

  ControlMesh take() { return std::move(mesh_); }

 private:
  Vector3d at(int guide, int particle) const { return guides_[guide].state.x.segment<3>(3 * particle); }

  std::span<const StrandStart> guides_;
  const MeshSpec& spec_;
  std::vector<int> first_;  // particle of each guide
  std::vector<Eigen::Matrix3d> frames_;
  ControlMesh mesh_;
};

}  // namespace

std::vector<Pair> neighbours(const std::vector<int>& starts, int guides, Neighbours which) {
  std::vector<Pair> pairs;
  for (std::size_t r = 0; r < starts.size(); ++r) {
    const int end = r + 1 < starts.size() ? starts[r + 1] : guides;
    for (int i = starts[r]; i + 1 < end; ++i) pairs.push_back({i, i + 1});
    if (which == Neighbours::rows || r + 1 == starts.size()) continue;
    const int after = r + 2 < starts.size() ? starts[r + 2] : guides;
    for (int i = starts[r]; i < end && end + i - starts[r] < after; ++i)
      pairs.push_back({i, end + i - starts[r]});
  }
  return pairs;
}

ControlMesh control_mesh(std::span<const StrandStart> guides, std::span<const Pair> pairs,
                         const MeshSpec& spec) {
  MeshMaker maker(guides, spec);
  for (const Pair& pair : pairs) {
    maker.link(pair);
    if (spec.strips) maker.lay_strip(pair);
  }
  return maker.take();
}

}  // namespace hair

#include "hair/dense/disorder.h"

#include <cmath>

#include "hair/groom/nearest_points.h"
#include "hair/strand/variation.h"

namespace hair {
namespace {

constexpr double kFlies =
    0.25;  // the largest sideways distance of a fly-away's tip, over its distance from the root

enum class Chance : std::uint64_t { clumps = 1, fly_aways };

}  // namespace

Disorder::Disorder(const SynthesisDescription& description) {
  if (description.clump > 0 && description.gathered > 0) choose_clumps(description);
  if (description.fly_aways > 0) choose_fly_aways(description);
}

void Disorder::choose_clumps(const SynthesisDescription& description) {
  Variation variation(description.seed, static_cast<std::uint64_t>(Chance::clumps));
  std::vector<Vector3d> middles;
  for (const RootFrame& root : description.children)
    if (variation.uniform(0, 1) * description.clump < 1) middles.push_back(root.position);
  const NearestPoints nearest(middles);
  gathers_.assign(description.children.size(), Vector3d::Zero());
  for (std::size_t i = 0; i < gathers_.size(); ++i) {
    const Vector3d& root = description.children[i].position;
    const long middle = nearest.nearest(root).index;
    if (middle >= 0) gathers_[i] = description.gathered * (middles[static_cast<std::size_t>(middle)] - root);
  }
}

void Disorder::choose_fly_aways(const SynthesisDescription& description) {
  Variation variation(description.seed, static_cast<std::uint64_t>(Chance::fly_aways));
  sways_.assign(description.children.size(), Vector3d::Zero());
  for (std::size_t i = 0; i < sways_.size(); ++i) {
    if (variation.uniform(0, 1) >= description.fly_aways) continue;
    for (double& part : sways_[i]) part = kFlies / std::sqrt(3.0) * variation.uniform(-1, 1);
    if (!gathers_.empty()) gathers_[i].setZero();
  }
}

void Disorder::apply(int child, const RootFrame& root, const ScalpTurn& turn,
                     std::span<const Eigen::Matrix3d> turns, Eigen::Ref<Eigen::VectorXd> points) const {
  const auto count = static_cast<int>(points.size() / 3);
  if (!gathers_.empty()) {
    const Vector3d way = turn * gathers_[child];
    for (int i = 1; i < count; ++i) {
      const double along = static_cast<double>(i) / (count - 1), part = along * (2 - along);
      // Like wisps, the offset between the roots turns with the nearest guide.
      if (turns.empty())
        points.segment<3>(3 * i) += part * way;
      else
        points.segment<3>(3 * i) += part * (turns[static_cast<std::size_t>(i)] * way);
    }
  }
  if (!sways_.empty() && !sways_[child].isZero(0)) {
    const Vector3d& sway = sways_[child];
    const double far = (points.tail<3>() - root.position).norm();
    const Vector3d aside =
        far * (root.axis * sway[0] + root.side * sway[1] + root.axis.cross(root.side) * sway[2]);
    for (int i = 1; i < count; ++i) {
      const double along = static_cast<double>(i) / (count - 1);
      points.segment<3>(3 * i) += along * along * aside;
    }
  }
}

double Disorder::reach(int child, double far) const {
  return (gathers_.empty() ? 0 : gathers_[child].norm()) + (sways_.empty() ? 0 : sways_[child].norm() * far);
}

}  // namespace hair

#include "hair/super_helix/helix_momentum.h"

namespace hair {

void HelixMomentum::keep(const HelixMotion& motion, const HelixRoot& root, Input rates) {
  places_.clear();
  velocities_.clear();
  elements_ = motion.elements;
  rates_ = rates;
  starts_.clear();
  kinetic_energy_ = 0;
  Twist twist{root.velocity, root.spin};
  std::size_t j = 0;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const HelixElement& helix = elements_[i];
    const Vector3d rate = rates.segment<3>(3 * i);
    starts_.push_back(twist);
    for (; j < motion.points.size() && motion.points[j].element == static_cast<int>(i); ++j) {
      const HelixPoint& point = motion.points[j];
      places_.push_back({point.element, point.s});
      velocities_.push_back(twist.velocity + twist.spin.cross(point.position - helix.start.position) +
                            point.moves * rate);
      kinetic_energy_ +=
          motion.strand().line_density * motion.weights[j] / 2 * velocities_.back().squaredNorm();
    }
    const Vector3d arm = helix.end.position - helix.start.position;
    twist.velocity += twist.spin.cross(arm) + helix.at_end.moves * rate;
    twist.spin += helix.at_end.turns * rate;
  }
}

// If an element's number of panels has changed, its nodes are at other places.
void HelixMomentum::add_to(HelixMotion& motion, double h) const {
  if (elements_.empty()) return;
  const double density = motion.strand().line_density;
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    HelixPoint& point = motion.points[j];
    const bool same = j < places_.size() && places_[j].element == point.element && places_[j].s == point.s;
    const Vector3d kept = same ? velocities_[j] : velocity_at(point.element, point.s);
    point.force += density * motion.weights[j] / h * (kept - motion.velocities[j]);
  }
}

Vector3d HelixMomentum::velocity_at(int element, double s) const {
  const HelixElement& helix = elements_[element];
  const Twist& start = starts_[element];
  const Vector3d arm = frame_at(helix.start, helix.curvature, s).position - helix.start.position;
  const Vector3d rate = rates_.segment<3>(3 * element);
  return start.velocity + start.spin.cross(arm) + jacobian_at(helix.start, helix.curvature, s).moves * rate;
}

}  // namespace hair

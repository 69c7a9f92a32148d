#include "hair/super_helix/helix_energy.h"

#include "hair/super_helix/helix_forces.h"

namespace hair {

HelixEnergy::HelixEnergy(const HelixStrand& strand, const HelixSurroundings& surroundings)
    : surroundings_(surroundings),
      watch_(strand.line_density * strand.lengths.sum(), strand.lengths.sum(), surroundings.gravity.norm(),
             surroundings.drag) {}

Energies HelixEnergy::read(const HelixMotion& motion, Input q, const Vector3d& root_velocity) {
  const HelixStrand& strand = motion.strand();
  Energies now{.elastic = elastic_energy(strand, q)};
  Vector3d moment = Vector3d::Zero();
  momentum_.setZero();
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    const double mass = strand.line_density * motion.weights[j];
    const Vector3d v = motion.velocities[j] - root_velocity;
    now.kinetic += mass / 2 * v.squaredNorm();
    momentum_ += mass * v;
    moment += mass * (motion.points[j].position - motion.elements.front().start.position);
  }
  now.weight = -surroundings_.gravity.dot(moment);
  return now;
}

void HelixEnergy::before_step(const HelixMotion& motion, Input q, const Vector3d& before,
                              const Vector3d& after) {
  before_ = before;
  after_ = after;
  if (!watch_.begun()) watch_.begin(read(motion, q, before));
}

void HelixEnergy::moved(const HelixMotion& motion) {
  velocities_ = motion.velocities;
}

void HelixEnergy::found(const HelixMotion& motion, double h, const Vector3d& spin, Input rates, Input change,
                        const ContactWork* contacts) {
  const HelixStrand& strand = motion.strand();
  const double drag = surroundings_.drag;
  Vector3d torque = Vector3d::Zero();
  const Vector3d root_velocity = (before_ + after_) / 2;
  work_ = contacts ? contacts->seen_from(root_velocity) : 0;
  in_contact_ = contacts != nullptr;
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    const HelixPoint& point = motion.points[j];
    const Vector3d &before = velocities_[j], &dv = motion.velocities[j];
    const Vector3d arm = point.position - motion.elements.front().start.position;
    torque += arm.cross(point.inertia * dv - h * point.force);
    if (drag > 0)
      work_ -= h * drag * motion.weights[j] *
               (before + dv - surroundings_.wind).dot(before + dv / 2 - root_velocity);
  }
  work_ += torque.dot(spin);
  for (int i = 0; i < strand.elements(); ++i) {
    const Vector3d after = rates.segment<3>(3 * i), mean = after - change.segment<3>(3 * i) / 2;
    work_ -= h * surroundings_.relaxation_time * strand.lengths[i] *
             (strand.bend_rigidity * after.head<2>().dot(mean.head<2>()) +
              strand.twist_rigidity * after[2] * mean[2]);
  }
}

void HelixEnergy::after_step(const HelixMotion& motion, Input q, double h) {
  const Vector3d momentum_before = momentum_;
  const Energies now = read(motion, q, after_);
  watch_.after_step(now, work_ - (after_ - before_).dot(momentum_before + momentum_) / 2, in_contact_, h);
}

}  // namespace hair

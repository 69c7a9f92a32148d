#include "hair/super_helix/helix_energy.h"

#include "hair/super_helix/helix_forces.h"

namespace hair {

HelixEnergy::HelixEnergy(const HelixStrand& strand, const HelixSurroundings& surroundings)
    : surroundings_(surroundings),
      mass_(strand.line_density * strand.lengths.sum()),
      watch_(mass_, strand.lengths.sum(), surroundings.gravity.norm(), surroundings.drag) {}

void HelixEnergy::read_motion(const HelixMotion& motion, const std::vector<Vector3d>& velocities,
                              const Vector3d& root_velocity) {
  now_.kinetic = 0;
  momentum_.setZero();
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    const double mass = motion.strand().line_density * motion.weights[j];
    const Vector3d v = velocities[j] - root_velocity;
    now_.kinetic += mass / 2 * v.squaredNorm();
    momentum_ += mass * v;
  }
}

void HelixEnergy::read_place(const HelixMotion& motion, Input q) {
  const Vector3d root = motion.elements.front().start.position;
  now_.elastic = elastic_energy(motion.strand(), q);
  now_.weight = weight_energy(surroundings_.gravity, motion) + mass_ * surroundings_.gravity.dot(root);
}

void HelixEnergy::before_step(const HelixMotion& motion, Input q, const Vector3d& before,
                              const Vector3d& after) {
  before_ = before;
  after_ = after;
  if (watch_.begun()) return;
  read_motion(motion, motion.velocities, before);
  read_place(motion, q);
  watch_.begin(now_);
}

void HelixEnergy::found(const HelixMotion& motion, const std::vector<Vector3d>& kept, double h,
                        const Vector3d& spin, Input rates, const ContactWork* contacts) {
  const HelixStrand& strand = motion.strand();
  const double drag = surroundings_.drag;
  const Vector3d root = motion.elements.front().start.position, changes = after_ - before_;
  Vector3d torque = Vector3d::Zero();
  work_ = contacts ? contacts->seen_from(after_) : 0;
  work_ -= changes.dot(momentum_ - mass_ / 2 * changes);
  in_contact_ = contacts != nullptr;
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    const HelixPoint& point = motion.points[j];
    torque += (point.position - root).cross(point.inertia * motion.velocities[j] - h * point.force);
    work_ -= h * drag * motion.weights[j] * (kept[j] - surroundings_.wind).dot(kept[j] - after_);
  }
  work_ += torque.dot(spin);
  for (int i = 0; i < strand.elements(); ++i) {
    const Vector3d rate = rates.segment<3>(3 * i);
    work_ -=
        h * surroundings_.relaxation_time * strand.lengths[i] *
        (strand.bend_rigidity * rate.head<2>().squaredNorm() + strand.twist_rigidity * rate[2] * rate[2]);
  }
  read_motion(motion, kept, after_);
}

void HelixEnergy::after_step(const HelixMotion& motion, Input q, double h) {
  read_place(motion, q);
  watch_.after_step(now_, work_, in_contact_, h);
}

}  // namespace hair

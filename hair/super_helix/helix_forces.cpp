#include "hair/super_helix/helix_forces.h"

namespace hair {

void add_motion(HelixMotion& motion) {
  const double density = motion.strand().line_density;
  for (std::size_t j = 0; j < motion.points.size(); ++j)
    motion.points[j].force -= density * motion.weights[j] * motion.accelerations[j];
}

void add_weight(const Vector3d& gravity, HelixMotion& motion) {
  const double density = motion.strand().line_density;
  for (std::size_t j = 0; j < motion.points.size(); ++j)
    motion.points[j].force += density * motion.weights[j] * gravity;
}

void add_drag(double drag, const Vector3d& wind, double h, HelixMotion& motion) {
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    const double resists = drag * motion.weights[j];
    motion.points[j].force -= resists * (motion.velocities[j] - wind);
    motion.points[j].inertia.diagonal().array() += h * resists;
  }
}

double elastic_energy(const HelixStrand& strand, Input q) {
  double energy = 0;
  for (int i = 0; i < strand.elements(); ++i) {
    const Vector3d bent = q.segment<3>(3 * i) - strand.natural.segment<3>(3 * i);
    energy +=
        strand.lengths[i] / 2 *
        (strand.bend_rigidity * bent.head<2>().squaredNorm() + strand.twist_rigidity * bent[2] * bent[2]);
  }
  return energy;
}

double weight_energy(const Vector3d& gravity, const HelixMotion& motion) {
  double energy = 0;
  for (std::size_t j = 0; j < motion.points.size(); ++j)
    energy -= motion.weights[j] * motion.points[j].position.dot(gravity);
  return motion.strand().line_density * energy;
}

double kinetic_energy(const HelixMotion& motion) {
  double energy = 0;
  for (std::size_t j = 0; j < motion.points.size(); ++j)
    energy += motion.weights[j] * motion.velocities[j].squaredNorm();
  return motion.strand().line_density / 2 * energy;
}

}  // namespace hair

// Forces on a super-helix, and its energies. Each function adds to the points of a motion, after place() and
// move().
#pragma once

#include "hair/super_helix/helix_motion.h"

namespace hair {

// A: - mass * acceleration at q" = 0, on all points, after accelerate(). It is explicit: for short steps, and
// to calculate q" itself. Long steps use momenta instead (helix_momentum.h).
void add_motion(HelixMotion& motion);

// gravity: m/s^2. It is explicit, and so is the tension T that holds hanging hair laterally; T is rho S g
// times the length. Steps of more than 4 sqrt(EI rho S) / T may gain energy, unless drag takes it.
void add_weight(const Vector3d& gravity, HelixMotion& motion);

// - drag * (velocity - wind) per metre, at the end of a step of h seconds; h = 0: at its beginning. drag: N
// s/m^2, wind: the air's velocity, m/s.
void add_drag(double drag, const Vector3d& wind, double h, HelixMotion& motion);

// J. Elastic energy is 0 at the natural shape, weight's energy at the origin; kinetic energy has no rotary
// inertia.
double elastic_energy(const HelixStrand& strand, Input q);
double weight_energy(const Vector3d& gravity, const HelixMotion& motion);
double kinetic_energy(const HelixMotion& motion);

}  // namespace hair

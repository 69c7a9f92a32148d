// Momenta that points keep from one step to the next: they replace A in long steps.
//
// A is the force of the accelerations that points have while q" = 0. In a whirling strand these change much
// within a long step. If they are taken at its beginning (add_motion), the strand gains energy until it blows
// up. But h A is the difference of two momenta: the one that each point has from the previous step, and the
// one that the same rates give it at its present position. So a step may take this difference itself:
//
// For h to 0 this is A. The step then finds the rates whose velocities are nearest to the kept ones, with
// masses as weights. Such a projection never makes velocities larger: kinetic energy grows only by the
// work of forces. The root's acceleration is included, too.
#pragma once

#include <vector>

#include "hair/super_helix/helix_motion.h"

namespace hair {

class HelixMomentum {
 public:
  // Call this after a step, with the strand still placed as before, the step's resulting rates, and the
  // root's velocity and spin in the step.
  void keep(const HelixMotion& motion, const HelixRoot& root, Input rates);

  // m/s, of the points at that place.
  const std::vector<Vector3d>& velocities() const { return velocities_; }
  double kinetic_energy() const { return kinetic_energy_; }  // J

  // Call this before the next step of h seconds, after place() and move() with the root's velocity and spin
  // in that step: adds the force to all points. Adds nothing before the first keep(). Both allocate nothing,
  // unless there are more points than ever.
  void add_to(HelixMotion& motion, double h) const;

 private:
  struct Place {
    int element;
    double s;
  };
  struct Twist {
    Vector3d velocity, spin;
  };
  Vector3d velocity_at(int element, double s) const;

  // Points, and elements at their starts.
  std::vector<Place> places_;
  std::vector<Vector3d> velocities_;
  std::vector<HelixElement> elements_;
  std::vector<Twist> starts_;
  Eigen::VectorXd rates_;
  double kinetic_energy_ = 0;
};

}  // namespace hair

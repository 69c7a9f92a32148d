// Momenta that points keep from one step to the next: A for steps that may be long.
//
// A is the force of the accelerations that points have while q" = 0. Those of a whirling strand change much
// within a long step, and where they are taken at its beginning (add_motion), the strand gains energy until
// it blows up. But h A is the momentum that each point has from the step before, less the one that the same
// rates give it where it lies now. So a step may take this difference itself:
//
//   force = mass * (velocity kept - velocity now) / h
//
// For h to 0 this is A. The step then finds the rates whose velocities are nearest to the kept ones, with
// masses as weights, and a projection never makes them larger: kinetic energy grows by the work of forces
// alone. The root's acceleration is in it, too.
#pragma once

#include <vector>

#include "hair/super_helix/helix_motion.h"

namespace hair {

class HelixMomentum {
 public:
  // After a step: of the strand as it is still placed, with the rates that the step has found and the root's
  // velocity and spin in the step.
  void keep(const HelixMotion& motion, const HelixRoot& root, Input rates);

  // Before the next step of h seconds, after place() and move() with the root's velocity and spin in that
  // step: adds the force to all points. Adds nothing before the first keep(). Both allocate nothing, unless
  // there are more points than ever.
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

  // Of points, and of elements at their starts.
  std::vector<Place> places_;
  std::vector<Vector3d> velocities_;
  std::vector<HelixElement> elements_;
  std::vector<Twist> starts_;
  Eigen::VectorXd rates_;
};

}  // namespace hair

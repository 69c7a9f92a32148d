// The energy of a super-helix in the frame that moves with its root, for the watch
// (hair/strand/energy_watch.h):
//
//   E = sum over points of m |v - V|^2 / 2 - m g . (x - x_0) + strain energy      J, V the root's velocity
//
// A step finds the velocities v at the places of its start, and keeps them as momenta
// (hair/super_helix/helix_momentum.h). The same rates have others at its end: for a tip that whips, with
// twice all energy. So v are the kept ones.
//
// A step's work has four parts: that of drag and of damping, force(1) . (v - V) h; that of contacts; that of
// a root that changes its velocity by dV, -dV . p + m dV^2 / 2, p the momentum before, in the root's frame;
// and that of a root that turns: its torque times its turn. The strand's own forces have no torque about the
// root. So the root's torque is the rest of the points' motion after all other forces,
//
//   h torque = sum over points of (x - x_0) x (inertia dv - h force)      dv: the velocity's change
#pragma once

#include "hair/strand/energy_watch.h"
#include "hair/super_helix/helix_motion.h"

namespace hair {

// The forces on a strand apart from its own stiffness.
struct HelixSurroundings {
  Vector3d gravity = Vector3d::Zero();  // m/s^2
  double drag = 0;                      // N s/m^2, per metre
  Vector3d wind = Vector3d::Zero();     // m/s, of the air
  double relaxation_time = 0;           // s: bends and twists also resist their rates, with this times K
};

class HelixEnergy {
 public:
  HelixEnergy(const HelixStrand& strand, const HelixSurroundings& surroundings);

  const EnergyWatch& watch() const { return watch_; }

  // The next step begins anew, from where the strand is then.
  void restart() { watch_.restart(); }

  // Call this before a step, with the root's velocities before and in the step. If the balance begins with
  // this step, `motion` must be placed and moved as it is now.
  void before_step(const HelixMotion& motion, Input q, const Vector3d& before, const Vector3d& after);

  // Takes the result of the step, with the strand still placed as before. `motion`'s velocities are the part
  // that `change` adds; kept: the points' velocities after the step; spin: the root's in the step.
  void found(const HelixMotion& motion, const std::vector<Vector3d>& kept, double h, const Vector3d& spin,
             Input rates, const ContactWork* contacts);

  // After the step, with the strand placed.
  void after_step(const HelixMotion& motion, Input q, double h);

 private:
  void read_motion(const HelixMotion& motion, const std::vector<Vector3d>& velocities,
                   const Vector3d& root_velocity);
  void read_place(const HelixMotion& motion, Input q);

  HelixSurroundings surroundings_;
  double mass_;                                                    // kg
  Vector3d before_ = Vector3d::Zero(), after_ = Vector3d::Zero();  // m/s, of the root
  Energies now_;
  Vector3d momentum_ = Vector3d::Zero();  // kg m/s, in the root's frame
  double work_ = 0;                       // J
  bool in_contact_ = false;
  EnergyWatch watch_;
};

}  // namespace hair

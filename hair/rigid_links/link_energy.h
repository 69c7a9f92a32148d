// The energy of a strand of rigid links in the frame that moves with its root, for the watch
// (hair/strand/energy_watch.h):
//
//   E = sum over links of m |v - V|^2 / 2 + omega^T I omega / 2 - m g . (x - x_0) + joints' springs, limits
//
// J, V the root's velocity. A step's work has four parts. Drag and dampers: force(1) . ((v0 + v1) / 2 - V) h.
// Contacts. A turning root: its torque, which H7's second pass finds, times its turn. A root that changes its
// velocity by dV: all mass feels this, -dV . (p0 + p1) / 2, p the momentum in the frame of its time; V is the
// mean of the root's velocities then.
#pragma once

#include "hair/rigid_links/link_strand.h"
#include "hair/rigid_links/tree_motion.h"
#include "hair/strand/energy_watch.h"

namespace hair {

class LinkEnergy {
 public:
  // Keeps a reference to the strand. implicit: forces are those at the end of a step.
  LinkEnergy(const LinkStrand& strand, bool implicit);

  const EnergyWatch& watch() const { return watch_; }

  // The next step begins anew, from where the strand is then.
  void restart() { watch_.restart(); }

  // Before a step that gives the base this velocity.
  void before_step(const SpatialMotion& base);

  // Call this after the step, when the base has this velocity. `motion` is the result of the step's passes.
  void after_step(const TreeMotion& motion, double h, const ContactWork* contacts);

 private:
  void read();
  double drag_work(const TreeMotion& motion, double h) const;
  double damping_work(const TreeMotion& motion, double h) const;

  const LinkStrand& strand_;
  bool implicit_;
  SpatialMotion base_, base_before_;
  Vector3d root_velocity_ = Vector3d::Zero();  // the mean in the step
  Eigen::VectorXd rates_before_;
  Energies energies_;
  Vector3d momentum_ = Vector3d::Zero(), momentum_before_ = Vector3d::Zero();  // kg m/s, in the root's frame
  EnergyWatch watch_;
};

}  // namespace hair

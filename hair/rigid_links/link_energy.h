// The energy of a strand of rigid links in the frame that moves with its root, for the watch
// (hair/strand/energy_watch.h):
//
//   E = sum over links of m |v - V|^2 / 2 + omega^T I omega / 2 - m g . (x - x_0) + joints' springs, limits
//
// J, V the root's velocity. A linearly implicit step finds v with the links at the places of its start; the
// same rates have others at its end. So v are the found ones.
//
// A step's work has four parts. Drag and dampers: force(1) . (v - V) h. Contacts. A turning root: its torque,
// which H7's second pass finds, times its turn. A root that changes its velocity by dV: all mass feels this,
// -dV . p + m dV^2 / 2, p the momentum before, in the root's frame. Explicit steps take the means of v, V,
// turn and p before and after.
#pragma once

#include "hair/rigid_links/link_strand.h"
#include "hair/rigid_links/tree_system.h"
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
  void before_step(const SpatialMotion& base, TreeSystem& system);

  // Call this after the step, when the base has this velocity. `system` has the result of the step's passes;
  // then it is placed at the step's end, as the next step needs it.
  void after_step(TreeSystem& system, double h, const ContactWork* contacts);

 private:
  // found: the step's velocities, in place of those of the present rates.
  void read(TreeSystem& system, bool found);
  double drag_work(const TreeSystem& system, double h) const;
  double damping_work(const TreeMotion& motion, double h) const;
  Vector3d mean(const Vector3d& before, const Vector3d& after) const;

  const LinkStrand& strand_;
  bool implicit_;
  SpatialMotion base_, base_before_;
  Vector3d root_velocity_ = Vector3d::Zero();  // for a step's work
  Eigen::VectorXd rates_before_;
  Energies energies_;
  Vector3d momentum_ = Vector3d::Zero(), momentum_before_ = Vector3d::Zero();  // kg m/s, in the root's frame
  double mass_;
  EnergyWatch watch_;
};

}  // namespace hair

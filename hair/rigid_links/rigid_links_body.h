// A strand of rigid links as a body. Its coordinates are the root's position and each link's turn: the
// rotation vector, rad, from the link's orientation in the rest shape to its present one. Inside, the body
// keeps the joints' quaternions and rates.
//
// Rods: point i of the centre line is the inner end of link i + 1, the last one is the tip.
#pragma once

#include <vector>

#include "hair/rigid_links/link_strand.h"
#include "hair/rigid_links/tree_steps.h"
#include "hair/rigid_links/tree_system.h"
#include "hair/strand/body.h"
#include "hair/strand/energy_watch.h"
#include "hair/strand/implicit_contacts.h"

namespace hair {

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

using TreeStep = void (TreeSteps::*)(const TreeBase& base, double h, std::span<const LinkForce> more,
                                     Output q, Output rates);

class RigidLinksBody final : public Body {
 public:
  // Obstacles need linearly implicit steps. `strand.forces` have weight and drag. The base is at rest at the
  // start, and moves with root_velocity from then on. watched: sizes() also has energies.
  RigidLinksBody(LinkStrand strand, const Vector3d& root_velocity, TreeStep method, bool watched = false);

  int size() const override { return 3 * points(); }
  int points() const override { return links() + 1; }
  Eigen::VectorXd arc_lengths() const override;
  int scratch_rows() const override { return 0; }
  int scratch_columns() const override { return 0; }
  void read(particles::Output q, particles::Output rate) const override;
  void write(particles::Input q, particles::Input rate) override;
  void set_root(const Root& root) override;
  Vector3d root_position() const override { return strand_.base.position; }
  std::optional<Stage> step(const BodyStep& step, const particles::Scratch& scratch, Work& work) override;
  void centre_line(particles::Input q, particles::Input rate, particles::Output x,
                   particles::Output v) const override;
  BodyMeasures measure(particles::Input q, particles::Input rate) const override;
  Sizes sizes() const override;

 private:
  int links() const { return static_cast<int>(strand_.length.size()); }
  const LinkShape& shape(int i) const { return strand_.tree.shapes()[i]; }
  void step_among(const BodyStep& step);
  void watch(const BodyStep& step);
  void find_points();
  void find_velocities_after(double h);
  bool is_sound() const;

  std::vector<Eigen::Quaterniond>
      at_rest_;        // the links' axes in the rest shape, for the root's frame at the start
  LinkStrand strand_;  // with the present base, q and rates
  TreeSteps steps_;
  TreeStep method_;
  Root root_;          // the base's next motion
  bool told_ = false;  // set_root was called for the next step
  std::vector<LinkForce> more_;
  // For steps with obstacles: the middle and the outer end of each rod (positions, and offsets from its
  // middle), and their velocities after the step.
  std::vector<ContactPoint> rod_points_;
  std::vector<Vector3d> arms_, after_;
  ImplicitContacts contacts_;
  Eigen::VectorXd q_before_, rates_before_;
  std::optional<LinkEnergy> energy_;
};

}  // namespace hair

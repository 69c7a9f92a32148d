// A strand of rigid links as a body. Its coordinates are the root's position and each link's turn: the
// rotation vector, rad, from the link's orientation in the rest shape to its present one. Inside, the body
// keeps the joints' quaternions and rates.
//
// Rods: point i of the centre line is the inner end of link i + 1, the last one is the tip.
#pragma once

#include <vector>

#include "hair/rigid_links/link_energy.h"
#include "hair/rigid_links/link_strand.h"
#include "hair/rigid_links/tree_steps.h"
#include "hair/strand/body.h"
#include "hair/strand/implicit_contacts.h"

namespace hair {

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

// A super-helix as a body. Its coordinates are the root's position, m; the turn of the root's frame since
// the start, as a vector, rad; and for each element the curvatures kappa1, kappa2 and the torsion tau,
// 1/m. It moves by H8's semi-implicit step, with forces at the points of its centre line (drag, contacts,
// forces of others) at the step's end. The motion itself needs the momenta of the previous step
// (helix_momentum.h). They are no part of the coordinates, so a state that is written back continues its
// motion only to the order of h^2. The kinetic energy of the present state is that of its momenta
// (helix_energy.h).
#pragma once

#include <vector>

#include "hair/strand/body.h"
#include "hair/strand/implicit_contacts.h"
#include "hair/super_helix/helix_energy.h"
#include "hair/super_helix/helix_momentum.h"
#include "hair/super_helix/helix_start.h"

namespace hair {

class SuperHelixBody final : public Body {
 public:
  // The root is at rest at the start, and moves with root_velocity from then on. watched: sizes() also has
  // energies.
  SuperHelixBody(HelixStart start, const HelixSurroundings& surroundings, const Vector3d& root_velocity,
                 bool watched = false);

  int size() const override { return 6 + static_cast<int>(q_.size()); }
  int points() const override { return static_cast<int>(places_.size()); }
  Eigen::VectorXd arc_lengths() const override;
  int scratch_rows() const override { return static_cast<int>(q_.size()); }
  int scratch_columns() const override { return static_cast<int>(q_.size()) + 10; }
  void read(particles::Output q, particles::Output rate) const override;
  void write(particles::Input q, particles::Input rate) override;
  void set_root(const Root& root) override;
  Vector3d root_position() const override { return root_.frame.position; }
  std::optional<Stage> step(const BodyStep& step, const particles::Scratch& scratch, Work& work) override;
  void centre_line(particles::Input q, particles::Input rate, particles::Output x,
                   particles::Output v) const override;
  BodyMeasures measure(particles::Input q, particles::Input rate) const override;
  Sizes sizes() const override;

 private:
  struct Push {
    Vector3d force;
    Matrix3d resists;
  };

  HelixRoot root_at(particles::Input q, particles::Input rate) const;
  HelixMotion motion_at(particles::Input q, particles::Input rate) const;
  void start_moving(const Vector3d& spin, double h);
  void add_forces(const BodyStep& step);
  void add_point_force(const PointForce& one, double h);
  const HelixStrand& strand_of_step(double h);
  void step_among(const BodyStep& step, const HelixStrand& strand, particles::Scratch scratch);
  void find_points();
  void find_velocities_after();
  void move_by_change();
  void weigh(double h);
  bool is_sound() const;

  Matrix3d axes_at_start_;
  HelixRoot root_;     // with its present frame
  Root goal_;          // the root's next motion
  bool told_ = false;  // set_root was called for the next step
  Eigen::VectorXd q_, rates_, change_;
  std::vector<double> places_;
  HelixMotion motion_;
  HelixMomentum momentum_;
  bool has_momentum_ = false;  // true after the first step
  bool placed_ = false;        // motion_ is placed at the present coordinates
  HelixSurroundings surroundings_;
  HelixStrand damped_;  // the strand of the step if it resists the rates of bends
  std::vector<ContactPoint> contact_points_;
  std::vector<Push> without_contacts_;  // on the contact points
  std::vector<Vector3d> after_;
  ImplicitContacts contacts_;
  std::optional<HelixEnergy> energy_;
};

}  // namespace hair

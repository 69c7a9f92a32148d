// A super-helix as a body. Its coordinates are the root's position, m; the turn of the root's frame since
// the start, as a vector, rad; and for each element the curvatures kappa1, kappa2 and the torsion tau,
// 1/m. It moves by H8's semi-implicit step, with forces at the points of its centre line (drag, contacts,
// forces of others) at the step's end. The motion itself needs the momenta of the previous step
// (helix_momentum.h). They are no part of the coordinates, so a state that is written back continues its
// motion only to the order of h^2. The kinetic energy of the present state is that of its momenta
// (HelixEnergy).
#pragma once

#include <vector>

#include "hair/strand/body.h"
#include "hair/strand/energy_watch.h"
#include "hair/strand/implicit_contacts.h"
#include "hair/super_helix/helix_momentum.h"
#include "hair/super_helix/helix_motion.h"
#include "hair/super_helix/helix_start.h"

namespace hair {

// The forces on a strand apart from its own stiffness.
struct HelixSurroundings {
  Vector3d gravity = Vector3d::Zero();  // m/s^2
  double drag = 0;                      // N s/m^2, per metre
  Vector3d wind = Vector3d::Zero();     // m/s, of the air
  double relaxation_time = 0;           // s: bends and twists also resist their rates, with this times K
};

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

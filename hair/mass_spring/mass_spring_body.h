// A strand of masses and springs as a body: its coordinates are its particles' positions, which also form its
// centre line.
#pragma once

#include "hair/mass_spring/force_parts.h"
#include "hair/mass_spring/moving_strand.h"
#include "hair/mass_spring/step_methods.h"
#include "hair/mass_spring/strand_start.h"
#include "hair/strand/body.h"
#include "hair/strand/energy_watch.h"
#include "hair/strand/measures.h"

namespace hair {

// The energy of a strand of masses and springs in the frame that moves with its root, for the watch
// (hair/strand/energy_watch.h):
//
//   E = sum_i m_i |v_i - V|^2 / 2 - sum_i m_i g . (x_i - x_0) + bending (+ stretching)    J, V: the root's
//
// A step's work is that of drag, F(v1) . ((v0 + v1) / 2 - V) h, and that of contacts, impulse . (an
// obstacle's velocity - V). When the root changes its velocity, the kinetic energy is read anew, and when its
// frame turns, the bending energy: the change counts as work from outside.
//
// Stretching is left out for methods that move particles along straight lines (H4). For moments it holds a
// hundred times the energy of the motion, which never receives it. If its mean over all steps is as large,
// springs hold the strand, and it does not move like hair.
class SpringEnergy {
 public:
  // `with_stretching`: see above. `every`: the number of steps that are read as one, for steps that are as
  // cheap as reading. Keeps a reference to the strand.
  SpringEnergy(const MovingStrand& moving, const Vector3d& gravity, double drag, bool with_stretching,
               int every);

  const EnergyWatch& watch() const { return watch_; }

  // The next step begins anew, from where the strand is then.
  void restart();

  void root_turned() { turned_ = true; }

  // Calls around a step. `v_before`: the velocities at its start, for the drag; `contacts`: null if there
  // were none.
  void before_step();
  // For methods whose particles do not follow their velocities, the means of a step.
  void moved(double h, particles::Input x_before, particles::Input v_before);
  void after_step(double h, particles::Input v_before, const ContactWork* contacts);

 private:
  double kinetic() const;
  double weight() const;
  Energies read();
  void close();

  const MovingStrand& moving_;
  Vector3d gravity_;
  bool with_stretching_, turned_ = false;
  int every_, open_ = 0;        // steps that are not read yet,
  double work_ = 0, time_ = 0;  // their work from outside, and their seconds,
  bool in_contact_ = false;
  Vector3d root_velocity_ = Vector3d::Zero();
  double bending_ = 0, unmoved_ = 0;
  EnergyWatch watch_;
};

class MassSpringBody final : public Body {
 public:
  // `start` has passed check_start. With `collides`, steps keep a copy of their start positions; with
  // `watched`, sizes() describes the last step.
  MassSpringBody(const StrandStart& start, const StepMethod& method, const ForceOptions& options,
                 bool collides, bool watched);

  const MovingStrand& moving() const { return moving_; }
  const EnergyWatch* energy_watch() const {
    return energy_ ? &energy_->watch() : nullptr;
  }  // null: nobody watches

  // Restarts from a start of the same size. Masses, lengths and forces stay the same.
  void restart(const StrandStart& start);
  void set_root_velocity(const Vector3d& velocity) { moving_.state.v.head<3>() = velocity; }
  void set_root_frame(const Vector3d& tangent, const Vector3d& normal);
  const Vector3d& root_normal() const { return root_normal_; }

  // Completes a step to x and v that was calculated elsewhere: its collisions and its record. On return x and
  // v hold the previous state.
  std::optional<Stage> step_to(const BodyStep& step, particles::Output x, particles::Output v,
                               const StepOutcome& outcome, Work& work);

  int size() const override { return 3 * moving_.strand.count(); }
  int points() const override { return moving_.strand.count(); }
  Eigen::VectorXd arc_lengths() const override { return hair::arc_lengths(moving_.strand); }
  int scratch_rows() const override { return size(); }
  int scratch_columns() const override { return method_.scratch + 2; }
  void read(particles::Output q, particles::Output rate) const override;
  void write(particles::Input q, particles::Input rate) override;
  void set_root(const Root& root) override;
  Vector3d root_position() const override { return moving_.state.x.head<3>(); }
  std::optional<Stage> step(const BodyStep& step, const particles::Scratch& scratch, Work& work) override;
  void centre_line(particles::Input q, particles::Input rate, particles::Output x,
                   particles::Output v) const override;
  BodyMeasures measure(particles::Input q, particles::Input rate) const override;
  Sizes sizes() const override { return sizes_; }

 private:
  // The results of a step's collisions.
  struct Collisions {
    ContactWork work;
    int contacts = 0;
    bool mended = true;
    double penetration = 0;  // m
  };
  Collisions collide(const BodyStep& step, particles::Input x_before, const particles::Scratch& scratch);
  std::optional<Stage> finish(const BodyStep& step, particles::Input x_before, particles::Input v_before,
                              const particles::Scratch& scratch, const StepOutcome& outcome, Work& work);
  void watch(double h, particles::Input v_before, const StepOutcome& outcome, const Collisions& collisions);

  MovingStrand moving_;
  const StepMethod& method_;
  Vector3d root_normal_;
  bool collides_;
  std::optional<SpringEnergy> energy_;  // for watched strands
  Sizes sizes_;
  long steps_ = 0, unmended_steps_ = 0, solves_ = 0, unconverged_ = 0;
};

}  // namespace hair

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
#pragma once

#include "hair/mass_spring/moving_strand.h"
#include "hair/strand/energy_watch.h"

namespace hair {

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

}  // namespace hair

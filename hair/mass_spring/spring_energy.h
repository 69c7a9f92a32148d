// The energy of a strand of masses and springs in the frame that moves with its root, for the watch
// (hair/strand/energy_watch.h):
//
//   E = sum_i m_i |v_i - V|^2 / 2 - sum_i m_i g . (x_i - x_0) + bending (+ stretching)      J, V the root's velocity
//
// A step's work is that of drag, F(v1) . ((v0 + v1) / 2 - V) h, and that of contacts, impulse . (an
// obstacle's velocity - V). When the root changes its velocity, the kinetic energy is read anew, and when its
// frame turns, the bending energy: that is work that came in.
//
// Stretching is left out where a method moves particles straight on instead of round (H4): for moments it
// holds a hundred times the energy that drives the motion, which never gets it. Where it holds as much all
// the time, springs hold the strand, and it does not move as hair does: that is what its mean shows.
#pragma once

#include "hair/mass_spring/moving_strand.h"
#include "hair/strand/energy_watch.h"

namespace hair {

class SpringEnergy {
 public:
  // `with_stretching`: see above. `every`: so many steps are read as one, where a step costs no more than
  // reading. Keeps a reference to the strand.
  SpringEnergy(const MovingStrand& moving, const Vector3d& gravity, double drag, bool with_stretching,
               int every);

  const EnergyWatch& watch() const { return watch_; }

  // The next step begins anew, from where the strand is then.
  void restart();

  void root_turned() { turned_ = true; }

  // Around a step. `v_before`: the velocities at its start, for the drag; `contacts`: null if there were
  // none.
  void before_step();
  void moved(
      double h,
      particles::Input x_before);  // of methods that may move particles otherwise than by their velocities
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
  double work_ = 0, time_ = 0;  // what came in there, and their seconds,
  bool in_contact_ = false;
  Vector3d root_velocity_ = Vector3d::Zero();
  double bending_ = 0, unmoved_ = 0;
  EnergyWatch watch_;
};

}  // namespace hair

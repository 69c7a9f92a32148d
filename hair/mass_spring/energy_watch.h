// The books of a strand's energy, in the frame that moves with its root: what it has, and what came in. A step of h
// seconds changes
//
//   E = sum_i m_i |v_i - V|^2 / 2 - sum_i m_i g . (x_i - x_0) + bending (+ stretching)      J, V the root's velocity
//
// by the drag's work F(v1) . ((v0 + v1) / 2 - V) h, by that of contacts, impulse . (an obstacle's velocity - V), and
// by what nothing gave. The latter is summed in two rows: of steps without contacts, and of steps with them. When the
// root changes its velocity, the kinetic energy is read anew, and when its frame turns, the bending energy: that is
// work that came in.
//
// Stretching is left out where a method moves particles straight on instead of round (H4): for moments it holds a
// hundred times the energy that drives the motion, which never gets it. Where it holds as much all the time, springs
// hold the strand, and it does not move as hair does: that is what its mean shows.
#pragma once

#include <algorithm>

#include "hair/mass_spring/moving_strand.h"

namespace hair {

// Means and shares of all steps begin to count here.
inline constexpr long kFewSteps = 20;

// What obstacles did in a step.
struct ContactWork {
  double work = 0;                      // J: their impulses times their velocities
  Vector3d impulse = Vector3d::Zero();  // N s, the sum
};

class EnergyWatch {
 public:
  // `with_stretching`: see above. Keeps a reference to the strand.
  EnergyWatch(const MovingStrand& moving, const Vector3d& gravity, bool with_stretching);

  // The next step begins anew, from where the strand is then.
  void restart() { begun_ = false; }

  void root_turned() { turned_ = true; }

  // Around a step. `v_before`: the velocities at its start, for the drag; `contacts`: null if there were none.
  void before_step();
  void after_step(double h, particles::Input v_before, const ContactWork* contacts);

  // The largest sum of either row so far, relative to E at the start + m |g| L + all work that came in +
  // what moves the strand by 1 mm/s.
  double gain() const { return gain_; }
  double contact_gain() const { return contact_gain_; }
  // J: what the last step added to either row, and what gains are relative to. Linked guides have common books: linked_energy.h.
  double last() const { return last_; }
  double scale() const { return scale_; }
  // The mean of the stretching energy over all steps, relative to the same; over kFewSteps, if there are fewer.
  double stretching() const { return stretching_ / std::max(steps_, kFewSteps); }

 private:
  struct Parts {
    double kinetic = 0, weight = 0, bending = 0, stretching = 0;
  };

  void begin();
  double kinetic() const;
  double weight() const;
  Parts read() const;
  double kept(const Parts& parts) const;
  void came_in(double work);

  const MovingStrand& moving_;
  Vector3d gravity_;
  bool with_stretching_, begun_ = false, turned_ = false;
  Vector3d root_velocity_ = Vector3d::Zero();
  Parts now_;
  double scale_ = 0, last_ = 0, free_ = 0, in_contact_ = 0, gain_ = 0, contact_gain_ = 0, stretching_ = 0;
  long steps_ = 0;
};

}  // namespace hair

// The energy balance of a body, in the frame that moves with its root: its energy, and the work from outside.
// A step changes E, its kinetic energy and its potential, by
//
//   the work of drag, dampers, obstacles and of a root that turns     the body knows it
//   energy from no source, or lost to none                            the method's error: this is watched
//
// The error is summed in two rows: for steps without contacts, and for steps with them. A gain is the
// height of a row above its lowest point, so that no gain hides behind an earlier loss. A loss is the
// depth of the first row below its highest point; losses in contacts are allowed. Drag takes energy, too,
// at the rate 2 c / mu (c: its coefficient, mu: mass, both per metre). So drag would soon have taken the
// energy that a method lost, and a loss fades at this rate.
//
// Gains and losses are relative to all energy that can be lost: E at the start, m |g| L, and all work from
// outside since. Two bounds follow (hair/strand/watch.cpp). A gain of 0.05 lifts a hair's middle by a
// twentieth of its length, which is visible. Hair that is released level and comes to rest has lost a half: a
// method of order one may take as much. Only a motion that the step does not resolve loses more than 0.6.
//
// A loss also tells how far off places are: about kOffByLoss times as much of the strand's length, within a
// factor of 3 (hair/MEASURED.md). With H4 it does not: stretching, which the balance leaves out, loses more.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace hair {

// Means and fractions of all steps count from this step on.
inline constexpr long kFewSteps = 20;

inline constexpr double kOffByLoss = 2;

// J, in the frame that moves with the root.
struct Energies {
  double kinetic = 0;
  double weight = 0;   // 0 for mass at the root
  double elastic = 0;  // 0 at rest
  double aside =
      0;  // elastic, outside the balance: stretching that comes and goes, without effect on the motion
  double unmoved = 0;  // kinetic, of velocities that differ from the last step's displacement

  double kept() const { return kinetic + weight + elastic; }
};

// The work of obstacles in a step.
struct ContactWork {
  double work = 0;                                    // J: their impulses times their velocities
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  // N s, the sum

  // The work in a frame with this velocity.
  double seen_from(const Eigen::Vector3d& velocity) const { return work - impulse.dot(velocity); }
};

// The height of a sum above its lowest point, and its depth below its highest.
class EnergyRow {
 public:
  // left: the part of the earlier depth that remains.
  void add(double amount, double left = 1) {
    risen_ = std::max(risen_ + amount, 0.0);
    fallen_ = std::max(left * fallen_ - amount, 0.0);
  }
  double risen() const { return risen_; }
  double fallen() const { return fallen_; }

 private:
  double risen_ = 0, fallen_ = 0;
};

class EnergyWatch {
 public:
  // For a body of this mass, kg, and length, m, under the weight |g|, m/s^2, with this drag, N s/m^2 per
  // metre.
  EnergyWatch(double mass, double length, double gravity, double drag = 0);

  bool begun() const { return begun_; }

  // The next step begins a new balance, from the body's state then.
  void restart() { *this = EnergyWatch(unit_, fading_); }

  // Call this before the first step. `now.aside` may move the body later.
  void begin(const Energies& now);

  // Call this before a step if the root has changed its velocity or its frame, and so E. The change counts as
  // work from outside.
  void root_moved(const Energies& now);

  // Call this after a step of h seconds, with its work from outside, J.
  void after_step(const Energies& now, double work, bool in_contact, double h = 0);

  // The largest so far, relative to all energy that can be lost.
  double gain() const { return gain_; }
  double contact_gain() const { return contact_gain_; }
  double loss() const { return loss_; }
  // The mean of `aside` over all steps, relative to the same; over kFewSteps, if there are fewer.
  double aside() const { return aside_ / static_cast<double>(std::max(steps_, kFewSteps)); }
  // The sum of `unmoved` over all steps, relative to the sum of kinetic energies plus a hundredth of m |g| L;
  // over kFewSteps at least.
  double unmoved() const {
    return unmoved_ / (moving_ + static_cast<double>(std::max(steps_, kFewSteps)) * unit_ / 100);
  }

  // J: the amount that the last step added to either row, and the energy that gains are relative to.
  double last() const { return last_; }
  double scale() const { return scale_; }
  const Energies& now() const { return now_; }

 private:
  EnergyWatch(double unit, double fading) : unit_(unit), fading_(fading) {}
  void come_in(double work) {
    came_in_ += std::max(work, 0.0);
    scale_ += std::max(work, 0.0);
  }

  double unit_, fading_;  // J, 1/s
  bool begun_ = false;
  Energies now_;
  EnergyRow free_, in_contact_;
  double spare_ = 0, scale_ = 0, came_in_ = 0, last_ = 0, gain_ = 0, contact_gain_ = 0, loss_ = 0;
  double aside_ = 0, unmoved_ = 0, moving_ = 0;
  long steps_ = 0;
};

}  // namespace hair

// The books of a body's energy, in the frame that moves with its root: the energy that it has, and the work
// that came in. A step changes E, its kinetic energy and its potential, by
//
//   the work of drag, dampers, obstacles and of a root that turns     the body knows it
//   energy that nothing gave or took                                  the method's error: what is watched
//
// The latter is summed in two rows: of steps without contacts, and of steps with them. A gain is how far a
// row has risen above its lowest point, so that no gain hides behind an earlier loss. A loss is how far the
// first row has fallen below its highest: contacts may take energy by right. Drag takes energy, too, at the
// rate 2 c / mu (c: its coefficient, mu: mass, both of a metre). So the air would soon have had what a method
// lost, and a loss fades at this rate.
//
// Gains and losses are relative to all that there was to lose: E at the start, m |g| L, and all work that
// came in since. Two bounds follow (hair/strand/watch.cpp). A gain of 0.05 lifts a hair's middle by a
// twentieth of its length, which is seen. And hair that is let go level and comes to rest has lost a half: so
// much a method of order one may take. Nothing but a motion that a step does not resolve takes more than 0.6.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace hair {

// Means and shares of all steps begin to count here.
inline constexpr long kFewSteps = 20;

// J, in the frame that moves with the root.
struct Energies {
  double kinetic = 0;
  double weight = 0;   // 0 for mass at the root
  double elastic = 0;  // 0 at rest
  double aside =
      0;  // elastic, and not in the books: stretching that comes and goes, which the motion does not feed on
  double unmoved = 0;  // kinetic, of velocities that the way of the last step does not show

  double kept() const { return kinetic + weight + elastic; }
};

// What obstacles did in a step.
struct ContactWork {
  double work = 0;                                    // J: their impulses times their velocities
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  // N s, the sum

  // The work as it is seen from a frame with this velocity.
  double seen_from(const Eigen::Vector3d& velocity) const { return work - impulse.dot(velocity); }
};

// How far a sum has risen above its lowest point, and fallen below its highest.
class EnergyRow {
 public:
  // left: of how far it has fallen before.
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
  // Of a body of this mass, kg, and length, m, under the weight |g|, m/s^2, with this drag, N s/m^2, for each
  // metre.
  EnergyWatch(double mass, double length, double gravity, double drag = 0);

  bool begun() const { return begun_; }

  // The next step begins anew, from where the body is then.
  void restart() { *this = EnergyWatch(unit_, fading_); }

  // Before the first step. What is aside then may move the body later.
  void begin(const Energies& now);

  // Before another step: the root has changed its velocity or its frame, so that E is another one. That is
  // work that came in.
  void root_moved(const Energies& now);

  // After a step of h seconds, in which this work came in, J.
  void after_step(const Energies& now, double work, bool in_contact, double h = 0);

  // The largest so far, relative to what there was to lose.
  double gain() const { return gain_; }
  double contact_gain() const { return contact_gain_; }
  double loss() const { return loss_; }
  // The mean of `aside` over all steps, relative to the same; over kFewSteps, if there are fewer.
  double aside() const { return aside_ / static_cast<double>(std::max(steps_, kFewSteps)); }
  // The sum of `unmoved` over all steps, relative to that of kinetic energies and of a hundredth of m |g| L;
  // over kFewSteps at least.
  double unmoved() const {
    return unmoved_ / (moving_ + static_cast<double>(std::max(steps_, kFewSteps)) * unit_ / 100);
  }

  // J: what the last step added to either row, and what gains are relative to.
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

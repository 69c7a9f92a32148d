// The energy of a toy for the watch (hair/strand/energy_watch.h): kinetic energy, weight and springs. The
// force of drag and dampers is the total force minus the total force at rest, at the same positions. Its
// work uses the velocities before and after a step. Rods and wires do no work; their feedback counts as an
// error of the method.
#pragma once

#include "hair/strand/energy_watch.h"
#include "particles/toys/moving_toy.h"

namespace hair {

class ToyEnergy {
 public:
  // Keeps a reference to the toy.
  explicit ToyEnergy(const particles::MovingToy& moving);

  const EnergyWatch& watch() const { return watch_; }

  // The next step begins anew, from where the toy is then.
  void restart() { watch_.restart(); }

  // Around a step.
  void before_step();
  void after_step(double h);

 private:
  Energies read() const;
  void find_drag(Eigen::VectorXd& drag);

  const particles::MovingToy& moving_;
  bool dissipates_, implicit_;
  Eigen::VectorXd v_before_, drag_before_, drag_, still_, nothing_;
  EnergyWatch watch_;
};

}  // namespace hair

// A toy as a body: its coordinates are its particles' positions. It has no root, no obstacles and no tip.
#pragma once

#include <optional>

#include "hair/strand/body.h"
#include "hair/strand/energy_watch.h"
#include "particles/toys/moving_toy.h"

namespace hair {

// The energy of a toy for the watch (hair/strand/energy_watch.h): kinetic energy, weight and springs. The
// force of drag and dampers is the total force minus the total force at rest, at the same positions. Its
// work uses the velocities before and after a step. Rods and wires do no work; their feedback counts as an
// error of the method.
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

class ToyBody final : public Body {
 public:
  // watched: sizes() describes the last step. Throws std::invalid_argument as MovingToy does.
  ToyBody(const particles::Toy& toy, bool watched);

  int size() const override { return static_cast<int>(moving_.state.x.size()); }
  int points() const override { return size() / 3; }
  Eigen::VectorXd arc_lengths() const override { return {}; }
  int scratch_rows() const override { return size(); }
  int scratch_columns() const override { return method_.scratch; }
  void read(particles::Output q, particles::Output rate) const override;
  void write(particles::Input q, particles::Input rate) override;
  void set_root(const Root&) override {}
  Vector3d root_position() const override { return moving_.state.x.head<3>(); }
  std::optional<Stage> step(const BodyStep& step, const particles::Scratch& scratch, Work& work) override;
  void centre_line(particles::Input q, particles::Input rate, particles::Output x,
                   particles::Output v) const override;
  BodyMeasures measure(particles::Input q, particles::Input rate) const override;
  Sizes sizes() const override;

  // The exercise that solves for its motion; "" if there is none.
  const char* solver() const;

 private:
  particles::MovingToy moving_;
  particles::ToyStep method_;
  std::optional<ToyEnergy> energy_;  // for watched toys
  particles::SolveCount all_;        // solves so far
};

}  // namespace hair

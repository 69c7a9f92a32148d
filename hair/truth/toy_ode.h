// A problem's toy as a system of ordinary differential equations: positions, then velocities, of the
// particles that are not pinned. Exercise P2 computes the forces of rods and wires.
#pragma once

#include "hair/truth/ode.h"
#include "hair/truth/problem.h"
#include "particles/toys/moving_toy.h"

namespace hair {

class ToyOde : public Ode {
 public:
  // Throws what particles::MovingToy throws.
  explicit ToyOde(const Problem& problem);

  int size() const override { return 6 * static_cast<int>(free_.size()); }
  Eigen::VectorXd start() const override;
  Eigen::VectorXd scales() const override;
  void rates(double t, particles::Input y, particles::Output dy) override;
  particles::State state(double t, particles::Input y) override;

 private:
  void unpack(double t, particles::Input y);

  particles::MovingToy moving_;
  std::vector<int> free_;  // particles
  double duration_;
  particles::State state_;
  Eigen::VectorXd acceleration_;
};

}  // namespace hair

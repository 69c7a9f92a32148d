// Time steps of a tree of links. Each takes q and rates from t to t + h; the base moves on its own, with its
// acceleration at t.
//
//                              order   passes   holds for
//   symplectic_euler             1        1     h omega < 2 for all joint springs: 2e-5 s for 1 cm of hair
//   runge_kutta_4                4        4     h omega < 2.8
//   linearly_implicit_euler      1        1     any joint spring and drag (hair/rigid_links/tree_system.h)
#pragma once

#include "hair/rigid_links/tree_system.h"

namespace hair {

// The base after t seconds.
TreeBase moved(const TreeBase& base, double t);

class TreeSteps {
 public:
  TreeSteps(const LinkTree& tree, TreeForces forces);

  TreeSystem& system() { return system_; }
  const TreeSystem& system() const { return system_; }

  // `base` is the base at t. Quaternions keep their length 1. No step allocates.
  void symplectic_euler(const TreeBase& base, double h, std::span<const LinkForce> more, Output q,
                        Output rates) {
    euler(base, h, 0, more, q, rates);
  }
  void runge_kutta_4(const TreeBase& base, double h, std::span<const LinkForce> more, Output q, Output rates);
  void linearly_implicit_euler(const TreeBase& base, double h, std::span<const LinkForce> more, Output q,
                               Output rates) {
    euler(base, h, h, more, q, rates);
  }

 private:
  // implicit_h: the forces that grow with q and q' are those after this time.
  void euler(const TreeBase& base, double h, double implicit_h, std::span<const LinkForce> more, Output q,
             Output rates);

  TreeSystem system_;
  Eigen::VectorXd a_, stage_q_, stage_rates_, slope_, sum_q_, sum_rates_;
};

}  // namespace hair

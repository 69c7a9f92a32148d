// Linear drag against moving air: f_i = -c_i (v_i - wind) on each particle. It has no energy.
#pragma once

#include "particles/force.h"

namespace particles {

class Drag : public Force {
 public:
  // coefficients c: n entries, N s/m, >= 0 (else throws std::invalid_argument); wind: the air's velocity,
  // m/s. For the same coefficient everywhere: Drag(Eigen::VectorXd::Constant(n, c)).
  explicit Drag(Eigen::VectorXd coefficients, const Vector3d& wind = Vector3d::Zero());

  double energy(Input x) const override;  // 0
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;  // 0
  void add_dfdv(Input x, Input v, Input dv, Output df) const override;
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                Scratch work) const override;

  // The work of the force at v_after, J, during h seconds in which velocities change from v_before to
  // v_after, in the frame that moves with `frame` (m/s).
  double work(double h, Input v_before, Input v_after, const Vector3d& frame) const;

 private:
  Eigen::VectorXd coefficients_;
  Vector3d wind_;
};

}  // namespace particles

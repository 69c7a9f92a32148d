// Gravity: f_i = m_i g on each particle, E = -sum m_i g . x_i.
#pragma once

#include "particles/force.h"

namespace particles {

inline constexpr double kEarthGravity = 9.81;  // m/s^2

class Gravity : public Force {
 public:
  // mass: n, kg; acceleration g in m/s^2, (0, 0, -kEarthGravity) on earth.
  Gravity(Eigen::VectorXd mass, const Vector3d& acceleration);

  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;  // 0
  void add_dfdv(Input x, Input v, Input dv, Output df) const override;  // 0
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                Scratch work) const override;

 private:
  Eigen::VectorXd mass_;
  Vector3d acceleration_;
  Eigen::VectorXd weight_;  // m_i g
};

}  // namespace particles

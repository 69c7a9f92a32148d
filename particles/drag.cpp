#include "particles/drag.h"

#include <utility>

#include "particles/require.h"
#include "solver/block_band.h"

namespace particles {

Drag::Drag(Eigen::VectorXd coefficients, const Vector3d& wind)
    : coefficients_(std::move(coefficients)), wind_(wind) {
  for (int i = 0; i < coefficients_.size(); ++i)
    require(coefficients_[i] >= 0, "Drag: coefficient", coefficients_[i], ">= 0");
}

double Drag::energy(Input /*x*/) const {
  return 0;
}

void Drag::add_force(Input /*x*/, Input v, Output f) const {
  for (int i = 0; i < coefficients_.size(); ++i)
    f.segment<3>(3 * i) -= coefficients_[i] * (v.segment<3>(3 * i) - wind_);
}

double Drag::work(double h, Input v_before, Input v_after, const Vector3d& frame) const {
  double power = 0;
  for (int i = 0; i < coefficients_.size(); ++i) {
    const Vector3d before = v_before.segment<3>(3 * i), after = v_after.segment<3>(3 * i);
    power -= coefficients_[i] * (after - wind_).dot((before + after) / 2 - frame);
  }
  return h * power;
}

void Drag::add_dfdx(Input /*x*/, Input /*v*/, Input /*dx*/, Output /*df*/) const {}

void Drag::add_dfdv(Input /*x*/, Input /*v*/, Input dv, Output df) const {
  for (int i = 0; i < coefficients_.size(); ++i)
    df.segment<3>(3 * i) -= coefficients_[i] * dv.segment<3>(3 * i);
}

bool Drag::add_band(Input /*x*/, Input /*v*/, double /*by_dfdx*/, double by_dfdv, solver::BlockBand& band,
                    Scratch /*work*/) const {
  for (int i = 0; i < coefficients_.size(); ++i)
    band.block(i, 0).diagonal().array() -= by_dfdv * coefficients_[i];
  return true;
}

}  // namespace particles

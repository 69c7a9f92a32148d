#include "particles/gravity.h"

#include <utility>

namespace particles {

Gravity::Gravity(Eigen::VectorXd mass, const Vector3d& acceleration)
    : mass_(std::move(mass)), acceleration_(acceleration), weight_(3 * mass_.size()) {
  for (int i = 0; i < mass_.size(); ++i) weight_.segment<3>(3 * i) = mass_[i] * acceleration;
}

double Gravity::energy(Input x) const {
  double energy = 0;
  for (int i = 0; i < mass_.size(); ++i) energy -= mass_[i] * acceleration_.dot(x.segment<3>(3 * i));
  return energy;
}

void Gravity::add_force(Input /*x*/, Input /*v*/, Output f) const {
  f += weight_;
}

void Gravity::add_dfdx(Input /*x*/, Input /*v*/, Input /*dx*/, Output /*df*/) const {}

void Gravity::add_dfdv(Input /*x*/, Input /*v*/, Input /*dv*/, Output /*df*/) const {}

bool Gravity::add_band(Input /*x*/, Input /*v*/, double /*by_dfdx*/, double /*by_dfdv*/,
                       solver::BlockBand& /*band*/, Scratch /*work*/) const {
  return true;
}

}  // namespace particles

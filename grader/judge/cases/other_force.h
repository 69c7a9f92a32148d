// STAFF ONLY. Forces that wrap another one and change one property.
#pragma once

#include <memory>
#include <utility>

#include "particles/force.h"
#include "particles/products_to_band.h"

namespace grader::inline judge {

class OtherForce : public particles::Force {
 public:
  explicit OtherForce(std::shared_ptr<const particles::Force> force) : force_(std::move(force)) {}
  double energy(particles::Input x) const override { return force_->energy(x); }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    force_->add_force(x, v, f);
  }
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override {
    force_->add_dfdx(x, v, dx, df);
  }
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override {
    force_->add_dfdv(x, v, dv, df);
  }

 protected:
  std::shared_ptr<const particles::Force> force_;
};

// Reports the band of df/dx: particles more than two apart are not coupled.
class Banded final : public OtherForce {
 public:
  using OtherForce::OtherForce;
  bool add_band(particles::Input x, particles::Input v, double by_dfdx, double /*by_dfdv*/,
                solver::BlockBand& band, particles::Scratch work) const override {
    const auto product = [&](particles::Input dx, particles::Output df) { add_dfdx(x, v, dx, df); };
    return particles::add_products(2, by_dfdx, product, band, work);
  }
};

}  // namespace grader::judge

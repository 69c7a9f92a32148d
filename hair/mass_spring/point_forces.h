// External forces at a strand's particles, as a part of its forces: links between hairs, penalties.
#pragma once

#include <span>

#include "hair/strand/body.h"
#include "particles/force.h"
#include "solver/block_band.h"

namespace hair {

class PointForces final : public particles::Force {
 public:
  // Valid until the next call. Keeps a reference to `forces`.
  void set(std::span<const PointForce> forces) { forces_ = forces; }

  // 0, because the source of these forces counts their energy.
  double energy(particles::Input) const override { return 0; }
  void add_force(particles::Input, particles::Input, particles::Output f) const override {
    for (const PointForce& one : forces_) f.segment<3>(3 * one.point) += one.force;
  }
  void add_dfdx(particles::Input, particles::Input, particles::Input dx,
                particles::Output df) const override {
    for (const PointForce& one : forces_)
      df.segment<3>(3 * one.point) -= one.stiffness * dx.segment<3>(3 * one.point);
  }
  void add_dfdv(particles::Input, particles::Input, particles::Input, particles::Output) const override {}
  bool add_band(particles::Input, particles::Input, double by_dfdx, double, solver::BlockBand& band,
                particles::Scratch) const override {
    for (const PointForce& one : forces_) band.block(one.point, 0) -= by_dfdx * one.stiffness;
    return true;
  }

 private:
  std::span<const PointForce> forces_;
};

}  // namespace hair

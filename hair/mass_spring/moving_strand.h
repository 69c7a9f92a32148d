// A strand with its state and its forces.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hair/mass_spring/rest_curvature.h"
#include "hair/strand.h"
#include "hair/strand/body.h"
#include "particles/drag.h"
#include "particles/force.h"
#include "particles/force_sum.h"
#include "particles/state.h"
#include "particles/system.h"
#include "solver/block_band.h"

namespace hair {

// External forces at a strand's particles, as a part of its forces: links between hairs, penalties.
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

// The strand's masses; the root is pinned.
inline particles::Particles held_at_root(const Strand& strand) {
  particles::Particles particles{strand.mass, std::vector<char>(strand.mass.size(), 0)};
  particles.pinned[0] = 1;
  return particles;
}

// Its parts refer to each other, so it can be neither copied nor moved.
struct MovingStrand {
  MovingStrand(Strand the_strand, particles::State start)
      : strand(std::move(the_strand)),
        particles(held_at_root(strand)),
        state(std::move(start)),
        system(particles, force) {}
  MovingStrand(const MovingStrand&) = delete;
  MovingStrand& operator=(const MovingStrand&) = delete;

  Strand strand;
  particles::Particles particles;
  particles::State state;
  particles::ForceSum force;
  // Parts of `force`: rest curvature, if the strand is curved at rest; external forces, if some act on it;
  // the parts whose energy depends on lengths, those for bends, and the air's drag, if there is one.
  RestCurvature* rest_curvature = nullptr;
  PointForces* point_forces = nullptr;
  std::vector<const particles::Force*> stretching, bending;
  const particles::Drag* drag = nullptr;
  particles::ParticleSystem system;  // for the explicit methods
};

}  // namespace hair

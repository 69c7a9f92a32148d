// A strand with its state and its forces.
#pragma once

#include <utility>
#include <vector>

#include "hair/mass_spring/point_forces.h"
#include "hair/mass_spring/rest_curvature.h"
#include "hair/strand.h"
#include "particles/drag.h"
#include "particles/force_sum.h"
#include "particles/state.h"
#include "particles/system.h"

namespace hair {

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

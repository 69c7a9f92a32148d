// STAFF ONLY. Strands for tests and benchmarks of the engine, and given code with the same forces.
#pragma once

#include <memory>

#include "hair/dense/full_head.h"
#include "hair/mass_spring/moving_strand.h"
#include "hair/mass_spring/strand_forces.h"
#include "hair/strand/make_strand.h"
#include "particles/drag.h"
#include "particles/gravity.h"

namespace hair::engine {

// Given code's strand with the forces of these settings, at rest along x from the origin.
inline std::unique_ptr<MovingStrand> given_strand(const FullHeadSettings& settings, int points,
                                                  double rest_length, const Vector3d& tangent) {
  Strand strand = uniform_strand(settings.material, points - 1, rest_length * (points - 1));
  strand.clamped = settings.clamped;
  strand.root_tangent = tangent;
  if (!settings.bending) strand.bend_rigidity = 0;
  particles::State start{Eigen::VectorXd::Zero(3 * points), Eigen::VectorXd::Zero(3 * points)};
  for (int i = 0; i < points; ++i) start.x[3 * i] = rest_length * i;
  auto moving = std::make_unique<MovingStrand>(std::move(strand), std::move(start));
  moving->force.emplace<StretchForce>(moving->strand, GeometricTerm::filtered);
  if (settings.bending) moving->force.emplace<BendForce>(moving->strand, Products::definite);
  moving->force.emplace<particles::Gravity>(moving->strand.mass, settings.gravity);
  if (settings.drag > 0)
    moving->force.emplace<particles::Drag>(settings.drag * moving->strand.mass, settings.wind);
  return moving;
}

}  // namespace hair::engine

// Straight human hair, clamped at its root, as a beam.
#pragma once

#include <memory>

#include "hair/mass_spring/moving_strand.h"
#include "hair/simulation/simulation.h"
#include "particles/gravity.h"

namespace hair {

using particles::kEarthGravity;

inline constexpr double kBeamLength = 0.05;  // m, the length of hair that swings or bends as a beam

// Gamma = rho g A L^3 / EI, weight over stiffness: 6.8 for human hair of 10 cm.
double weight_over_stiffness(const Material& material, double length);
double length_of(const Material& material, double weight_over_stiffness);

// At rest, starting at the origin; the root's tangent has the direction `direction` (of length 1).
StrandStart clamped_hair(const Material& material, int segments, double length, const Vector3d& direction);

// With H1, H2 (exact products) and gravity, but without an integrator: for statics.
std::unique_ptr<MovingStrand> under_gravity(const StrandStart& start, const Vector3d& gravity);

}  // namespace hair

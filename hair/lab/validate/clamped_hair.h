// Human hair that is straight and clamped at its root, as engineers know beams.
#pragma once

#include <memory>

#include "hair/mass_spring/moving_strand.h"
#include "hair/simulation/simulation.h"

namespace hair {

inline constexpr double kEarth = 9.81;       // m/s^2
inline constexpr double kBeamLength = 0.05;  // m, of hair that swings or bends as a beam

// Gamma = rho g A L^3 / EI, weight against stiffness: 6.8 of human hair of 10 cm.
double weight_over_stiffness(const Material& material, double length);
double length_of(const Material& material, double weight_over_stiffness);

// At rest, from the origin on, its root's tangent along `direction` (of length 1).
StrandStart clamped_hair(const Material& material, int segments, double length, const Vector3d& direction);

// With H1, H2 (exact products) and gravity, and nothing that moves it: for statics.
std::unique_ptr<MovingStrand> under_gravity(const StrandStart& start, const Vector3d& gravity);

}  // namespace hair

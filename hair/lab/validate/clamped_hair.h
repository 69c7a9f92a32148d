// Straight human hair, clamped at its root, as a beam.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "hair/mass_spring/moving_strand.h"
#include "hair/simulation/simulation.h"
#include "particles/gravity.h"

namespace hair {

using particles::kEarthGravity;

inline constexpr double kBeamLength = 0.05;  // m, the length of hair that swings or bends as a beam

// From Gamma = rho g A L^3 / EI, weight over stiffness: 6.8 for human hair of 10 cm.
double length_of(const Material& material, double weight_over_stiffness);

// At rest, starting at the origin; the root's tangent has the direction `direction` (of length 1).
StrandStart clamped_hair(const Material& material, int segments, double length, const Vector3d& direction);

// With H1, H2 (exact products) and gravity, but without an integrator: for statics.
std::unique_ptr<MovingStrand> under_gravity(const StrandStart& start, const Vector3d& gravity);

// ---- As a beam ----
//
// A beam that is clamped at one end and free at the other, without gravity: its oscillations in theory and as
// a strand. Source of the theory: S. S. Rao, "Vibration of Continuous Systems" (2007), chapter 11.
//
// Mode k has the frequency w = (b/L)^2 sqrt(EI / rho A), with cos(b) cosh(b) = -1: b = 1.875104, 4.694091,
// 7.854757.
//
// A strand of n segments has half a segment's mass at its tip and half a segment's bending at its clamp, so
// its frequency has a second-order error. The error: take Rayleigh's quotient of the beam's shape phi with
// the strand's energies, sums over joints instead of integrals. It differs from w^2 by (1/6 n^2) (phi''(0)
// phi'''(0) - b^4 * integral of phi'^2) / b^4, with phi''(0) = 2 b^2, phi'''(0) = -2 S b^3, and the integral
// S b (2 + S b), with L as the unit of length:
//
//   w_n^2 = w^2 (1 - S b (6 + S b) / 6 n^2 + O(1/n^4)),   S = (cos(b) + cosh(b)) / (sin(b) + sinh(b)).

// b of mode 1, 2, ..., exact up to rounding.
double clamped_beam_root(int mode);

// S b (6 + S b) / 6 of mode 1, 2, ...
double clamped_beam_error(int mode);

struct BeamModes {
  Eigen::VectorXd frequencies;  // rad/s, increasing: one for each segment
  Eigen::MatrixXd shapes;       // columns: the sideways motion of particles 1 to n; of mass-weighted length 1
};

// The modes of a horizontal straight strand, from the exact products of H1 and H2, for motions in its
// vertical plane. The strand comes from clamped_hair, along x.
BeamModes beam_modes(const StrandStart& start);

// b from a frequency: (w^2 rho A L^4 / EI)^(1/4).
double beam_root_of(const Material& material, double length, double frequency);

}  // namespace hair

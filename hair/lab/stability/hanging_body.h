// A strand that its model divides, hanging at rest, as in hanging.h for masses and springs. It is measured
// only through its body. With q the small change of its coordinates, except those of the root, its energies
// are
//
//   kinetic = q'^T M q' / 2        potential = q^T K q / 2 + a constant
//
// so differences of energies give M and K. A body without weight gives the elastic part P of K.
//
// It hangs straight down, whatever its shape in the scene, clamped downwards, and its fibre does not resist
// rates: the modes of M and K are then independent, and drag damps each of them on its own. The body's first
// three coordinates are the root's position, the others angles.
#pragma once

#include <Eigen/Core>

#include "hair/lab/stability/experiment.h"
#include "hair/lab/stability/hanging.h"

namespace hair {

struct HangingBody {
  ModelledStrand strand;
  double length = 0, mass = 0;  // m, kg
  Eigen::VectorXd rest;         // all coordinates
  Modes modes;                  // shape^T M shape = 1
  Eigen::MatrixXd inertia;      // M
  Eigen::MatrixXd elastic;      // P between modes: shape^T P shape, 1/s^2
  // 1/s, for each mode, for a drag of 1 N s/m^2. A twist about the strand meets no drag.
  Eigen::VectorXd drag_per_mass;

  double fastest() const { return modes.omega.maxCoeff(); }
  double fastest_with_drag(bool has_drag) const;  // 1/s, the modes that drag damps; or the others
};

// The description's strand, with its moduli times `stiffness`. Throws BadInput for a strand that is not
// clamped, or has no restoring force.
HangingBody hang_body(const Description& hair, double stiffness);

// Gives every mode the same energy, as rates with pseudo-random signs. The energy is so small that no element
// turns by more than 1e-6.
struct BodyDisturbance {
  Eigen::VectorXd rates;      // for all coordinates
  double energy_of_mode = 0;  // J
};
BodyDisturbance disturb(const HangingBody& hanging);

// As for masses and springs.
Outcome run_disturbed(const Description& hair, const HangingBody& hanging, const BodyDisturbance& disturbance,
                      double drag, double h, long steps);

// The largest step with which nothing grows by more than `growth` in a step: of each mode's oscillator for
// explicit methods, implicit_limit (theory.h) with P in the matrix for the linearly implicit one.
double limit_of(Method method, const HangingBody& hanging, double drag, double growth);

// 1/s: the frequency of the fastest motion that weight alone, which steps take explicitly, holds; of all if
// there is none.
double fastest_by_weight(const HangingBody& hanging);

}  // namespace hair

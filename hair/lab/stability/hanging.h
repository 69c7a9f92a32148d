// A strand that hangs at rest, its modes, and a disturbance of all modes: the start of each run of a
// stability map.
//
// The strand hangs straight down from its root at the origin, whatever its shape in the scene; a clamped
// strand is clamped downwards. Then small motions along the strand and across it are independent, and the two
// directions across are equivalent, so that one of them is enough.
#pragma once

#include <Eigen/Core>

#include "hair/simulation/simulation.h"

namespace hair {

// The modes of n - 1 free particles in one direction, from M x'' = -K x: the columns of `shape`, with shape^T
// M shape = 1.
struct Modes {
  Eigen::MatrixXd stiffness;  // K, N/m
  Eigen::VectorXd omega;      // 1/s, increasing
  Eigen::MatrixXd shape;      // 1/sqrt(kg)
};

struct Hanging {
  StrandStart start;      // at rest; the root, particle 0, is at the origin
  Vector3d down, across;  // unit vectors
  Eigen::VectorXd mass;   // kg, of all particles except the root
  Modes along_modes, across_modes;
  double drag_per_mass = 0;    // 1/s, for a drag of 1 N s/m^2: gamma is this times the description's drag
  bool keeps_lengths = false;  // the start has the rest lengths, and nothing moves along the strand

  double fastest() const;  // 1/s
};

// The description's first strand, with its rigidities times `stiffness` as for another Young's modulus. With
// keeps_lengths (H6) the segments start with their rest lengths: the weight does not stretch them; the modes
// are the same. Throws BadInput if the strand is not held, or if there is no restoring force; passes on
// exceptions of stubs.
Hanging hang(const Description& hair, double stiffness, bool keeps_lengths);

// The matrices of a method's products for this hair: -df/dx, along and across, for all particles except the
// root.
struct ProductParts {
  Eigen::MatrixXd along, across;
};
ProductParts products_of(const Description& hair, const Hanging& hanging, GeometricTerm term,
                         Products product);

// 1/s: the frequency of the fastest motion across the hair that tension alone holds; of all if there is none.
double fastest_by_tension(const Description& hair, const Hanging& hanging);

// Gives every mode the same energy, as velocities with pseudo-random signs. The energy is so small that every
// segment stays in tension and turns by at most 1e-3: the motion stays linear. With keeps_lengths there is no
// motion along.
struct Disturbance {
  particles::State state;
  double energy_of_mode = 0;  // J
  int modes = 0;
};
Disturbance disturb(const Hanging& hanging);

}  // namespace hair

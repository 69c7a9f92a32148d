// A strand that hangs at rest, its modes, and a disturbance of all of them: what a stability map's runs start from.
//
// It hangs straight down from its root at the origin, whatever shape it has in the scene; a clamped one is clamped
// downwards. Small motions along the strand and across it are then independent of each other, and the two directions
// across are alike, so that one of them will do.
#pragma once

#include <Eigen/Core>

#include "hair/simulation/simulation.h"

namespace hair {

// The modes of n - 1 free particles in one direction, of M x'' = -K x: columns of `shape`, with shape^T M shape = 1.
struct Modes {
  Eigen::MatrixXd stiffness;  // K, N/m
  Eigen::VectorXd omega;      // 1/s, increasing
  Eigen::MatrixXd shape;      // 1/sqrt(kg)
};

struct Hanging {
  StrandStart start;      // at rest; the root, particle 0, is at the origin
  Vector3d down, across;  // of length 1
  Eigen::VectorXd mass;   // kg, of the particles but the root
  Modes along_modes, across_modes;
  double drag_per_mass = 0;    // 1/s, for a drag of 1 N s/m^2: gamma is this times the description's drag
  bool keeps_lengths = false;  // the start has the lengths at rest, and nothing moves along

  double fastest() const;  // 1/s
};

// A description's first strand with its rigidities times `stiffness`: those of a material with another Young's modulus.
// What keeps lengths (H6) starts with the lengths at rest: the weight does not stretch it; the modes are the same.
// Throws BadInput for a strand that nothing holds, or nothing brings back, and what the exercises' stubs throw.
Hanging hang(const Description& hair, double stiffness, bool keeps_lengths);

// The matrices that a method's products make of this hair: -df/dx, along and across, of particles but the root.
struct ProductParts {
  Eigen::MatrixXd along, across;
};
ProductParts products_of(const Description& hair, const Hanging& hanging, GeometricTerm term,
                         Products product);

// The same energy for every mode, as velocities, with signs that look random. So little that no segment comes out of
// tension, and nowhere does the strand turn by more than 1e-3: all stays linear. What keeps lengths gets no motion along.
struct Disturbance {
  particles::State state;
  double energy_of_mode = 0;  // J
  int modes = 0;
};
Disturbance disturb(const Hanging& hanging);

}  // namespace hair

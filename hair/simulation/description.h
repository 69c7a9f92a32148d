// The input of a simulation of strands: plain data.
#pragma once

#include <optional>
#include <vector>

#include "hair/geometric_term.h"
#include "hair/linked_guides/control_mesh.h"
#include "hair/mass_spring/strand_forces.h"
#include "hair/mass_spring/strand_start.h"
#include "hair/obstacles/obstacles.h"
#include "hair/simulation/methods.h"
#include "hair/strand/strand_spec.h"
#include "particles/gravity.h"

namespace hair {

struct ModelRow;

// A strand that its model divides into elements when the simulation is assembled.
struct ModelledStrand {
  const ModelRow* model;  // a row of the table of models
  StrandSpec spec;
};

struct Description {
  std::vector<StrandStart> strands;      // masses and springs
  std::vector<ModelledStrand> modelled;  // any model; their indices follow those of `strands`
  Method method = Method::predictor_corrector;
  double step = 1.0 / 240;                                       // s
  Vector3d gravity = Vector3d(0, 0, -particles::kEarthGravity);  // m/s^2
  double drag = 0;                                               // N s/m^2, per metre of hair
  Vector3d wind = Vector3d::Zero();                              // m/s, of the air
  std::vector<Obstacle> obstacles;
  // Links and strips between `strands`, which are one system then: implicit_euler only, and clamped strands.
  std::optional<ControlMesh> mesh;
  bool point_forces = false;  // steps also apply forces at points of strands
  // Watches for numbers that are finite and wrong (hair/strand/watch.h). With false no energy is read,
  // because its exercises may be unwritten.
  bool watched = true;

  int jobs = 1;  // threads that step strands, >= 1; exercises' code then runs in all of them at a time

  // Only for implicit methods.
  std::optional<GeometricTerm> geometric_term;  // for a segment's product; empty: row_of(method).usual_term()
  Products bend_product = Products::definite;
  double tolerance = 1e-10;    // residual of a solve, relative to its right-hand side
  bool preconditioner = true;  // solves use the band of the forces (particles/preconditioner.h)
};

}  // namespace hair

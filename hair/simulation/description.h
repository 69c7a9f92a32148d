// What a simulation of strands is made of: plain data.
#pragma once

#include <vector>

#include "hair/geometric_term.h"
#include "hair/mass_spring/strand_forces.h"
#include "hair/mass_spring/strand_start.h"
#include "hair/simulation/methods.h"
#include "hair/strand/obstacles.h"
#include "hair/strand/strand_spec.h"

namespace hair {

struct ModelRow;

// A strand that its model cuts into parts when the simulation is assembled.
struct ModelledStrand {
  const ModelRow* model;  // of the table of models
  StrandSpec spec;
};

struct Description {
  std::vector<StrandStart> strands;      // of masses and springs
  std::vector<ModelledStrand> modelled;  // of any model; they are counted after those
  Method method = Method::predictor_corrector;
  double step = 1.0 / 240;                   // s
  Vector3d gravity = Vector3d(0, 0, -9.81);  // m/s^2
  double drag = 0;                           // N s/m^2: for each metre of hair
  Vector3d wind = Vector3d::Zero();          // m/s, of the air that drags
  std::vector<Obstacle> obstacles;
  bool point_forces = false;  // steps come with forces at points of strands

  // Of implicit methods alone; newton_euler, whose result they don't change, has products of its own choice.
  GeometricTerm geometric_term = GeometricTerm::filtered;
  Products bend_product = Products::definite;
  double tolerance = 1e-10;  // of a solve's residual, relative to its right-hand side
};

}  // namespace hair

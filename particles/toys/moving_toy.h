// The state of a moving toy and its step function: the exercises' methods behind one signature.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "particles/dynamics.h"
#include "particles/force_sum.h"
#include "particles/system.h"
#include "particles/toys/toy.h"

namespace particles {

// The effort of all solves so far.
struct SolveCount {
  long steps = 0;  // iterations of ConjGrad
  long solves = 0;
  long unconverged = 0;  // includes constraints only if they are watched
  double left = 0;       // their largest residual, relative to its right-hand side
};

// Its parts refer to each other, so it can be neither copied nor moved.
struct MovingToy {
  // watched: measures how well constraints are solved, which costs a few more products. Throws
  // std::invalid_argument for values that are out of bounds, not finite or of the wrong size.
  explicit MovingToy(const Toy& description, bool watched = false);
  MovingToy(const MovingToy&) = delete;
  MovingToy& operator=(const MovingToy&) = delete;

  Toy toy;
  State state;
  ForceSum force;                      // all forces except those of constraints
  std::unique_ptr<Dynamics> dynamics;  // for the explicit methods; empty with implicit Euler
  SolveCount solves;
};

struct ToyStep {
  void (*step)(MovingToy&, const StepOptions&, const Scratch&);
  int scratch;  // columns of 3n numbers
};

ToyStep toy_step_of(ToyMethod method);

// The exercises that the toy's rods and wires need.
std::vector<std::string> exercises_of_constraints(const Toy& toy);

// The largest | |d| - l0 | / l0 of all springs and rods with l0 > 0, or of rods alone. NaN if one of these
// lengths is NaN.
double largest_stretch(const Toy& toy, Input x);
double largest_rod_stretch(const Toy& toy, Input x);

// The parts of a toy that call an exercise.
extern const ToyStep kToyForwardEuler, kToySymplecticEuler, kToyMidpoint, kToyRungeKutta4;
extern const ToyStep kToyImplicitEuler;
// The acceleration of a toy under its constraints. Keeps a reference to the toy.
std::unique_ptr<Dynamics> constrained_dynamics(MovingToy& moving, bool watched);

}  // namespace particles

// A toy that moves, and how it takes a step: the exercises' methods behind one signature, as hair/methods.h
// has them for strands.
#pragma once

#include <memory>

#include "hair/methods.h"
#include "hair/scene/toy.h"
#include "particles/dynamics.h"
#include "particles/force_sum.h"

namespace hair {

// What solves took so far.
struct SolveCount {
  long steps = 0;  // of ConjGrad
  long unconverged = 0;
};

// Its parts refer to each other, so that it stays where it was made.
struct MovingToy {
  // Throws std::invalid_argument for what is out of bounds, not finite or of the wrong size, and for what
  // needs an exercise that the course leaves out.
  explicit MovingToy(const Toy& description);
  MovingToy(const MovingToy&) = delete;
  MovingToy& operator=(const MovingToy&) = delete;

  Toy toy;
  particles::State state;
  particles::ForceSum force;                      // all that acts, but constraints
  std::unique_ptr<particles::Dynamics> dynamics;  // what explicit methods see; none with implicit Euler
  SolveCount solves;
};

struct ToyStep {
  void (*step)(MovingToy&, const StepOptions&, const particles::Scratch&);
  int scratch;  // columns of 3n numbers
};

ToyStep toy_step_of(ToyMethod method);

// The largest | |d| - l0 | / l0 of all springs and rods whose l0 is not 0. NaN if a length is.
double largest_stretch(const Toy& toy, particles::Input x);

}  // namespace hair

// A toy that moves, and how it takes a step: the exercises' methods behind one signature.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "particles/dynamics.h"
#include "particles/force_sum.h"
#include "particles/step_options.h"
#include "particles/toys/toy.h"

namespace particles {

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
  State state;
  ForceSum force;                      // all that acts, but constraints
  std::unique_ptr<Dynamics> dynamics;  // what explicit methods see; none with implicit Euler
  SolveCount solves;
};

struct ToyStep {
  void (*step)(MovingToy&, const StepOptions&, const Scratch&);
  int scratch;  // columns of 3n numbers
};

// Throws std::invalid_argument for one that the course leaves out.
ToyStep toy_step_of(ToyMethod method);

// The exercises that the toy's rods and wires call.
std::vector<std::string> exercises_of_constraints(const Toy& toy);

// The largest | |d| - l0 | / l0 of all springs and rods whose l0 is not 0. NaN if a length is.
double largest_stretch(const Toy& toy, Input x);

}  // namespace particles

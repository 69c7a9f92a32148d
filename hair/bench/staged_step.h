// A step of H6 with a clock: the time that each part takes.
#pragma once

#include "hair/strand.h"
#include "particles/force.h"
#include "particles/state.h"

namespace hair_bench {

// Sums, in seconds.
struct Stages {
  double products = 0;  // with df/dx and df/dv
  double forces = 0;
  double bands = 0;   // the preconditioners' assembly, by products
  double solver = 0;  // factors, and ConjGrad's own sweeps over vectors
  double correction = 0;
  double all = 0;
};

void staged_step(const particles::Force& force, const particles::Particles& particles,
                 const hair::Strand& strand, double h, particles::State& state, Eigen::MatrixXd& scratch,
                 Stages& stages);

}  // namespace hair_bench

// H4: linearly implicit Euler. The contract is in particles/implicit_euler.h, the text in
// assignment/H4-implicit-euler.md.

#include "particles/implicit_euler.h"

#include "solver/not_implemented.h"

namespace particles {

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& /*force*/, const Particles& /*particles*/,
                                                const State& /*state*/, double /*a*/, double /*b*/) {
  throw NotImplemented("H4 implicit_matrix");
}

SolveReport solve_implicit(const Force& /*force*/, const Particles& /*particles*/, const State& /*state*/,
                           double /*a*/, double /*b*/, double /*tolerance*/, Output /*dv*/,
                           Scratch /*scratch*/) {
  throw NotImplemented("H4 solve_implicit");
}

SolveReport implicit_euler(const Force& /*force*/, const Particles& /*particles*/, double /*h*/,
                           double /*tolerance*/, State& /*state*/, Scratch /*scratch*/) {
  throw NotImplemented("H4 implicit_euler");
}

}  // namespace particles

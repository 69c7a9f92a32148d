// H4: linearly implicit Euler. The contract is in particles/implicit_euler.h, the text in
// exercises/H4/text.md.

#include "particles/implicit_euler.h"

#include "particles/solve_implicit.h"
#include "solver/not_implemented.h"

namespace particles {

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& /*force*/, const Particles& /*particles*/,
                                                const State& /*state*/, double /*a*/, double /*b*/) {
  throw NotImplemented("H4 implicit_matrix");
}

void implicit_rhs(const Force& /*force*/, const Particles& /*particles*/, const State& /*state*/,
                  double /*a*/, double /*b*/, Output /*rhs*/) {
  throw NotImplemented("H4 implicit_rhs");
}

SolveReport solve_plain(implicitMatrix& /*matrix*/, Output /*rhs*/, double /*tolerance*/, int /*most_steps*/,
                        Output /*dv*/) {
  throw NotImplemented("H4 solve_plain");
}

SolveReport implicit_euler(const Force& /*force*/, const Particles& /*particles*/, double /*h*/,
                           double /*tolerance*/, State& /*state*/, Scratch /*scratch*/) {
  throw NotImplemented("H4 implicit_euler");
}

}  // namespace particles

// P2: constraint forces. The contract is in particles/constraint_forces.h, the text in
// exercises/P2/text.md.

#include "particles/constraint_forces.h"

#include "solver/not_implemented.h"

namespace particles {

void constraint_values(const Constraints& /*constraints*/, Input /*x*/, Output /*C*/) {
  throw NotImplemented("P2 constraint_values");
}

void constraint_rates(const Constraints& /*constraints*/, Input /*x*/, Input /*v*/, Output /*rates*/) {
  throw NotImplemented("P2 constraint_rates");
}

void add_constraint_forces(const Constraints& /*constraints*/, Input /*x*/, Input /*lambda*/, Output /*f*/) {
  throw NotImplemented("P2 add_constraint_forces");
}

std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& /*constraints*/,
                                                  const Particles& /*particles*/, const State& /*state*/) {
  throw NotImplemented("P2 constraint_matrix");
}

ConstraintReport solve_constraints(const Constraints& /*constraints*/, const Particles& /*particles*/,
                                   const State& /*state*/, Input /*f*/, Output /*lambda*/) {
  throw NotImplemented("P2 solve_constraints");
}

}  // namespace particles

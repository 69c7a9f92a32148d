// P1: explicit integrators. The contract is in particles/explicit_integrators.h, the text in
// exercises/P1/text.md.

#include "particles/explicit_integrators.h"

#include "solver/not_implemented.h"

namespace particles {

void forward_euler(Dynamics& /*dynamics*/, double /*h*/, Output /*x*/, Output /*v*/, Scratch /*scratch*/) {
  throw NotImplemented("P1 forward_euler");
}

void symplectic_euler(Dynamics& /*dynamics*/, double /*h*/, Output /*x*/, Output /*v*/, Scratch /*scratch*/) {
  throw NotImplemented("P1 symplectic_euler");
}

void midpoint(Dynamics& /*dynamics*/, double /*h*/, Output /*x*/, Output /*v*/, Scratch /*scratch*/) {
  throw NotImplemented("P1 midpoint");
}

void runge_kutta_4(Dynamics& /*dynamics*/, double /*h*/, Output /*x*/, Output /*v*/, Scratch /*scratch*/) {
  throw NotImplemented("P1 runge_kutta_4");
}

}  // namespace particles

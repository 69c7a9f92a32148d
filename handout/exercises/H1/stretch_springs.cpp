// H1: stretch springs. The contract is in hair/stretch_springs.h, the text in
// exercises/H1/text.md.

#include "hair/stretch_springs.h"

#include "solver/not_implemented.h"

namespace hair {

double stretch_energy(const Strand& /*strand*/, Input /*x*/) {
  throw NotImplemented("H1 stretch_energy");
}

void add_stretch_force(const Strand& /*strand*/, Input /*x*/, Output /*f*/) {
  throw NotImplemented("H1 add_stretch_force");
}

void add_stretch_product(const Strand& /*strand*/, Input /*x*/, GeometricTerm /*term*/, Input /*dx*/,
                         Output /*df*/) {
  throw NotImplemented("H1 add_stretch_product");
}

}  // namespace hair

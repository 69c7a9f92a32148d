// H3: springs that skip a particle. The contract is in hair/bend_springs.h, the text in
// exercises/H3/text.md.

#include "hair/bend_springs.h"

#include "solver/not_implemented.h"

namespace hair {

double bend_spring_energy(const Strand& /*strand*/, Input /*x*/) {
  throw NotImplemented("H3 bend_spring_energy");
}

void add_bend_spring_force(const Strand& /*strand*/, Input /*x*/, Output /*f*/) {
  throw NotImplemented("H3 add_bend_spring_force");
}

void add_bend_spring_product(const Strand& /*strand*/, Input /*x*/, GeometricTerm /*term*/, Input /*dx*/,
                             Output /*df*/) {
  throw NotImplemented("H3 add_bend_spring_product");
}

}  // namespace hair

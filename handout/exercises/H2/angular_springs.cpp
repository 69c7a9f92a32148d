// H2: angular springs. The contract is in hair/angular_springs.h, the text in
// exercises/H2/text.md.

#include "hair/angular_springs.h"

#include "solver/not_implemented.h"

namespace hair {

double bend_energy(const Strand& /*strand*/, Input /*x*/) {
  throw NotImplemented("H2 bend_energy");
}

void add_bend_force(const Strand& /*strand*/, Input /*x*/, Output /*f*/) {
  throw NotImplemented("H2 add_bend_force");
}

void add_bend_product(const Strand& /*strand*/, Input /*x*/, Input /*dx*/, Output /*df*/) {
  throw NotImplemented("H2 add_bend_product");
}

void add_bend_product_spd(const Strand& /*strand*/, Input /*x*/, Input /*dx*/, Output /*df*/) {
  throw NotImplemented("H2 add_bend_product_spd");
}

}  // namespace hair

#include "hair/bend_springs.h"
#include "hair/mass_spring/strand_forces.h"
#include "particles/products_to_band.h"

namespace hair {

double BendSpringForce::energy(Input x) const {
  return bend_spring_energy(strand_, x);
}

void BendSpringForce::add_force(Input x, Input, Output f) const {
  add_bend_spring_force(strand_, x, f);
}

void BendSpringForce::add_dfdx(Input x, Input, Input dx, Output df) const {
  add_bend_spring_product(strand_, x, term_, dx, df);
}

bool BendSpringForce::add_band(Input x, Input, double by_dfdx, double, solver::BlockBand& band,
                               particles::Scratch work) const {
  return particles::add_products(
      2, by_dfdx, [&](Input dx, Output df) { add_bend_spring_product(strand_, x, definite(term_), dx, df); },
      band, work);
}

}  // namespace hair

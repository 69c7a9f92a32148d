#include "hair/mass_spring/strand_forces.h"
#include "hair/stretch_springs.h"
#include "particles/products_to_band.h"

namespace hair {

double StretchForce::energy(Input x) const {
  return stretch_energy(strand_, x);
}

void StretchForce::add_force(Input x, Input, Output f) const {
  add_stretch_force(strand_, x, f);
}

void StretchForce::add_dfdx(Input x, Input, Input dx, Output df) const {
  add_stretch_product(strand_, x, term_, dx, df);
}

bool StretchForce::add_band(Input x, Input, double by_dfdx, double, solver::BlockBand& band,
                            particles::Scratch work) const {
  return particles::add_products(
      1, by_dfdx, [&](Input dx, Output df) { add_stretch_product(strand_, x, definite(term_), dx, df); },
      band, work);
}

}  // namespace hair

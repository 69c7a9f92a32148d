#include "hair/angular_springs.h"
#include "hair/mass_spring/strand_forces.h"
#include "particles/products_to_band.h"

namespace hair {

double BendForce::energy(Input x) const {
  return bend_energy(strand_, x);
}

void BendForce::add_force(Input x, Input, Output f) const {
  add_bend_force(strand_, x, f);
}

void BendForce::add_dfdx(Input x, Input, Input dx, Output df) const {
  if (product_ == Products::exact)
    add_bend_product(strand_, x, dx, df);
  else
    add_bend_product_spd(strand_, x, dx, df);
}

bool BendForce::add_band(Input x, Input, double by_dfdx, double, solver::BlockBand& band,
                         particles::Scratch work) const {
  return particles::add_products(
      2, by_dfdx, [&](Input dx, Output df) { add_bend_product_spd(strand_, x, dx, df); }, band, work);
}

}  // namespace hair

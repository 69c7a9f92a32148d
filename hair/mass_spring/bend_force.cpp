#include "hair/mass_spring/strand_forces.h"

#include "hair/angular_springs.h"

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

}  // namespace hair

#include "hair/mass_spring/strand_forces.h"

#include "hair/bend_springs.h"

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

}  // namespace hair

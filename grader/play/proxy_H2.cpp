// STAFF ONLY. H2, asked of the student's worker.
#include "grader/play/strand_proxy.h"
#include "hair/angular_springs.h"

namespace hair {

double bend_energy(const Strand& strand, Input x) {
  return grader::asked_energy(strand, x);
}

void add_bend_force(const Strand& strand, Input x, Output f) {
  grader::ask_to_add(1, GeometricTerm::full, strand, x, {}, f);
}

void add_bend_product(const Strand& strand, Input x, Input dx, Output df) {
  grader::ask_to_add(2, GeometricTerm::full, strand, x, dx, df);
}

void add_bend_product_spd(const Strand& strand, Input x, Input dx, Output df) {
  grader::ask_to_add(3, GeometricTerm::full, strand, x, dx, df);
}

}  // namespace hair

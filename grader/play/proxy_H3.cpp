// STAFF ONLY. H3, asked of the student's worker.
#include "grader/play/strand_proxy.h"
#include "hair/bend_springs.h"

namespace hair {

double bend_spring_energy(const Strand& strand, Input x) {
  return grader::asked_energy(strand, x);
}

void add_bend_spring_force(const Strand& strand, Input x, Output f) {
  grader::ask_to_add(1, GeometricTerm::full, strand, x, {}, f);
}

void add_bend_spring_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  grader::ask_to_add(2, term, strand, x, dx, df);
}

}  // namespace hair

// STAFF ONLY. H1, asked of the student's worker.
#include "grader/play/strand_proxy.h"
#include "hair/stretch_springs.h"

namespace hair {

double stretch_energy(const Strand& strand, Input x) {
  return grader::asked_energy(strand, x);
}

void add_stretch_force(const Strand& strand, Input x, Output f) {
  grader::ask_to_add(1, GeometricTerm::full, strand, x, {}, f);
}

void add_stretch_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  grader::ask_to_add(2, term, strand, x, dx, df);
}

}  // namespace hair

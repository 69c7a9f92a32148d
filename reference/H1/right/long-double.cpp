// STAFF ONLY. A right H1 in long double, as the lecture has it: E = 1/2 k (l - l_rest)^2 with k ~ 1/l_rest.
#include "hair/stretch_springs.h"

#include <algorithm>

namespace hair {
namespace {

using Real = long double;
using Long3 = Eigen::Matrix<Real, 3, 1>;

Long3 difference(Input x, int i) {
  return x.segment<3>(3 * i + 3).cast<Real>() - x.segment<3>(3 * i).cast<Real>();
}

// Pulls the ends of segment i together.
void pull(int i, const Long3& force, Output f) {
  f.segment<3>(3 * i) += force.cast<double>();
  f.segment<3>(3 * i + 3) -= force.cast<double>();
}

}  // namespace

double stretch_energy(const Strand& strand, Input x) {
  Real E = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Real l_rest = strand.rest_length[i], k = strand.stretch_rigidity / l_rest;
    const Real l = difference(x, i).norm();
    E += k * (l - l_rest) * (l - l_rest) / 2;
  }
  return static_cast<double>(E);
}

void add_stretch_force(const Strand& strand, Input x, Output f) {
  for (int i = 0; i < strand.segments(); ++i) {
    const Long3 e = difference(x, i);
    const Real l_rest = strand.rest_length[i], k = strand.stretch_rigidity / l_rest, l = e.norm();
    if (l > 0) pull(i, k * (l - l_rest) / l * e, f);
  }
}

void add_stretch_product(const Strand& strand, Input x, GeometricTerm term, Input dx, Output df) {
  for (int i = strand.segments() - 1; i >= 0; --i) {
    const Long3 e = difference(x, i), de = difference(dx, i);
    const Real l_rest = strand.rest_length[i], k = strand.stretch_rigidity / l_rest, l = e.norm();
    if (!(l > 0)) continue;
    const Long3 along = e.dot(de) / (l * l) * e;
    Real across = 1 - l_rest / l;
    if (term == GeometricTerm::filtered) across = std::max(across, Real{0});
    if (term == GeometricTerm::dropped) across = 0;
    pull(i, k * (along + across * (de - along)), df);
  }
}

}  // namespace hair

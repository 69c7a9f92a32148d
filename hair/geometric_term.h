// How a force's product treats a spring's geometric term.
#pragma once

namespace hair {

// The derivative of a spring's force k (l - l0) u, where u is the unit vector along the spring and l its
// length, is
//   k u u^T + k (1 - l0/l) (I - u u^T),
//
// up to its sign. The second term, the geometric term, comes from the rotation of the spring. It is negative
// for a compressed spring (l < l0): the matrix of an implicit step may then be indefinite, and ConjGrad ends
// early.
enum class GeometricTerm {
  full,      // the exact derivative
  filtered,  // k max(1 - l0/l, 0): exact in tension, 0 in compression
  dropped    // 0
};

// The term closest to this one with which products are definite.
constexpr GeometricTerm definite(GeometricTerm term) {
  return term == GeometricTerm::full ? GeometricTerm::filtered : term;
}

}  // namespace hair

// What a force's product makes of a spring's geometric term.
#pragma once

namespace hair {

// The derivative of a spring's force k (l - l0) u, with u the unit vector along it and l its length, is
//
//   k u u^T + k (1 - l0/l) (I - u u^T),
//
// up to its sign. The second, the geometric term, is how the force turns with the spring. Of a compressed spring
// (l < l0) it is negative: the matrix of an implicit step is then not positive definite, and ConjGrad ends.
enum class GeometricTerm {
  full,      // as it is: the exact derivative
  filtered,  // k max(1 - l0/l, 0): the same in tension, none in compression
  dropped    // none
};

}  // namespace hair

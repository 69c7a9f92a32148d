// The matrix of a force's products with df/dx: the exact derivative, or one that suits an implicit step.
#pragma once

namespace particles {

enum class Products {
  exact,    // the exact df/dx. It may have positive eigenvalues, and with damping it is not symmetric
  definite  // df/dx without those parts: symmetric and negative semi-definite, so that ConjGrad can solve
};

}  // namespace particles

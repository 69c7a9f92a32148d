// What a force's products with df/dx are: its derivative, or what an implicit step would rather have.
#pragma once

namespace particles {

enum class Products {
  exact,    // df/dx as it is. It may have positive eigenvalues, and with damping it is not symmetric
  definite  // df/dx without those parts: symmetric and negative semi-definite, so that ConjGrad can solve
};

}  // namespace particles

// STAFF ONLY. The categories of S1 and their points.
#include "grader/exercise/S1/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::s1 {

WholeRunPoints whole_run() {
  return {1, 1};
}

std::vector<Category> categories() {
  return {{"Examples", "The lecture's examples", 2, examples},
          {"Empty", "Nothing to solve", 1, empty},
          {"Sizes", "Sizes from 1 to 10,000", 2, sizes},
          {"KnownMatrices", "Known matrices", 4, known_matrices},
          {"IllConditioned", "Ill-conditioned systems", 2, ill_conditioned},
          {"Clusters", "Clustered eigenvalues", 1, clusters},
          {"StiffStrand", "A stiff strand", 3, stiff_strand},
          {"FirstGuess", "The first guess", 2, first_guess},
          {"StepLimit", "The step limit", 2, step_limit},
          {"Tolerance", "The tolerance", 3, tolerance},
          {"ReturnValue", "The return value", 2, return_value},
          {"Scaling", "Very large and very small numbers", 1, scaling},
          {"NotPositiveDefinite", "Matrices that are not positive definite", 2, not_positive_definite},
          {"NotFinite", "Numbers that are not finite", 1, not_finite},
          {"Products", "The number of products", 1, products},
          {"CallAfterCall", "Call after call", 1, call_after_call}};
}

}  // namespace grader::s1

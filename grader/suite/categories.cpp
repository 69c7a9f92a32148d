// STAFF ONLY. The hidden suites' tables of contents: what is tried, and what it is worth.
#include "grader/course/bad_input.h"
#include "grader/suite/s1_categories.h"
#include "grader/suite/s2_categories.h"
#include "grader/suite/trial.h"

namespace grader {

std::vector<Category> categories(const std::string& exercise) {
  if (exercise == "S1")
    return {{"Examples", "The lecture's examples", 2, s1::examples},
            {"Sizes", "Sizes from 0 to 10,000", 3, s1::sizes},
            {"KnownMatrices", "Known matrices", 4, s1::known_matrices},
            {"IllConditioned", "Ill-conditioned systems", 2, s1::ill_conditioned},
            {"Clusters", "Clustered eigenvalues", 1, s1::clusters},
            {"StiffStrand", "A stiff strand", 3, s1::stiff_strand},
            {"FirstGuess", "The first guess", 2, s1::first_guess},
            {"StepLimit", "The step limit", 2, s1::step_limit},
            {"Tolerance", "The tolerance", 3, s1::tolerance},
            {"ReturnValue", "The return value", 2, s1::return_value},
            {"Scaling", "Very large and very small numbers", 1, s1::scaling},
            {"NotPositiveDefinite", "Matrices that are not positive definite", 2, s1::not_positive_definite},
            {"NotFinite", "Numbers that are not finite", 1, s1::not_finite},
            {"Products", "The number of products", 1, s1::products},
            {"CallAfterCall", "Call after call", 1, s1::call_after_call}};
  if (exercise == "S2")
    return {{"Table", "A matrix from a table", 4, s2::table},
            {"NormalOperator", "A'A as an operator", 4, s2::normal_operator},
            {"NonSymmetric", "Non-symmetric systems", 4, s2::non_symmetric},
            {"Indefinite", "Indefinite systems", 3, s2::indefinite},
            {"LeastSquares", "Least squares", 2, s2::least_squares},
            {"StepsAndProducts", "Steps and products", 3, s2::steps_and_products}};
  throw BadInput("exercise " + exercise + " has no hidden suite; the suites are S1 and S2");
}

}  // namespace grader

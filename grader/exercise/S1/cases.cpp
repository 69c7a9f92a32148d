// STAFF ONLY. The categories of S1 and their points.
#include "grader/exercise/S1/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::s1 {

WholeRunPoints whole_run() {
  return {1, 1};
}

std::vector<Category> categories() {
  return {{"Systems", "Systems", 7, systems},
          {"Sizes", "Sizes from 1 to 10,000", 2, sizes},
          {"Hard", "Hard systems", 4, hard_systems},
          {"Empty", "Nothing to solve", 1, empty},
          {"FirstGuess", "The first guess", 2, first_guess},
          {"StepLimit", "The step limit", 2, step_limit},
          {"Tolerance", "The tolerance", 3, tolerance},
          {"ReturnValue", "The return value", 2, return_value},
          {"Scaling", "Very large and very small numbers", 1, scaling},
          {"NotPositiveDefinite", "Matrices that are not positive definite", 2, not_positive_definite},
          {"NotFinite", "Numbers that are not finite", 1, not_finite},
          {"SixtyFourth", "The 64th step", 2, sixty_fourth},
          {"CallAfterCall", "Call after call", 1, call_after_call}};
}

}  // namespace grader::s1

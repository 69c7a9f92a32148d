// STAFF ONLY. The cases of each category of S1.
#include "reference/S1/cases.h"

namespace grader::s1 {

Cases cases() {
  return {{"Systems", systems},
          {"Sizes", sizes},
          {"Hard", hard_systems},
          {"Empty", empty},
          {"FirstGuess", first_guess},
          {"StepLimit", step_limit},
          {"Tolerance", tolerance},
          {"ReturnValue", return_value},
          {"Scaling", scaling},
          {"NotPositiveDefinite", not_positive_definite},
          {"NotFinite", not_finite},
          {"SixtyFourth", sixty_fourth},
          {"CallAfterCall", call_after_call}};
}

}  // namespace grader::s1

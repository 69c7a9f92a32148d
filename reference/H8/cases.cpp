// STAFF ONLY. The cases of each category of H8.
#include "reference/H8/cases.h"

namespace grader::h8 {

Cases cases() {
  return {{"Functions", functions},
          {"NearlyStraight", nearly_straight},
          {"CentreLine", centre_line},
          {"CarriedFrames", carried_frames},
          {"Stiffness", stiffness},
          {"Elasticity", elasticity},
          {"Jacobians", jacobians},
          {"Winding", winding},
          {"Forces", forces},
          {"Masses", masses},
          {"BareElements", bare_elements},
          {"Steps", steps},
          {"StiffSteps", stiff_steps},
          {"OtherUnits", other_units}};
}

}  // namespace grader::h8

// STAFF ONLY. The categories of H8 and their weights.
#include "grader/exercise/H8/cases.h"

namespace grader::h8 {

std::vector<Category> categories() {
  return {{"Functions", "Stumpff's functions", 2, functions},
          {"NearlyStraight", "Nearly straight elements", 3, nearly_straight},
          {"CentreLine", "The centre line and frame of an element", 3, centre_line},
          {"CarriedFrames", "Frames carried from element to element", 2, carried_frames},
          {"Stiffness", "Stiffness", 1, stiffness},
          {"Elasticity", "Elastic forces", 2, elasticity},
          {"Jacobians", "Jacobians of an element", 5, jacobians},
          {"Winding", "Elements that wind many times", 1, winding},
          {"Forces", "Generalised forces", 2, forces},
          {"Masses", "The mass matrix", 3, masses},
          {"BareElements", "Elements without points", 1, bare_elements},
          {"Steps", "The step", 3, steps},
          {"StiffSteps", "Straight hair, long steps, many elements", 1, stiff_steps},
          {"OtherUnits", "Hair of any size and weight", 1, other_units}};
}

}  // namespace grader::h8

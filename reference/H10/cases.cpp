// STAFF ONLY. The cases of each category of H10.
#include "reference/H10/cases.h"

namespace grader::h10 {

Cases cases() {
  return {{"WeightsInside", weights_inside},
          {"WeightsOutside", weights_outside},
          {"ThinTriangles", thin_triangles},
          {"NoWidth", no_width},
          {"FlatScalp", flat_scalp},
          {"CurvedScalp", curved_scalp},
          {"Arcs", arcs},
          {"CarriedTurns", carried_turns},
          {"Folds", folds},
          {"Wisps", wisps},
          {"Spreading", spreading},
          {"Blends", blends},
          {"Units", other_units}};
}

}  // namespace grader::h10

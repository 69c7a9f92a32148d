// STAFF ONLY. The cases of each category of H9.
#include "reference/H9/cases.h"

namespace grader::h9 {

Cases cases() {
  return {{"Strengths", strengths},
          {"Histories", histories},
          {"LinkEnergies", link_energies},
          {"LinkForces", link_forces},
          {"TurnedFrames", turned_frames},
          {"WornLinks", worn_links},
          {"LinkProducts", link_products},
          {"Touches", touches},
          {"FlatTriangles", flat_triangles},
          {"Weights", weights},
          {"NoDirections", no_directions},
          {"StripForces", strip_forces},
          {"StripProducts", strip_products},
          {"Frictions", frictions},
          {"PinnedFrictions", pinned_frictions},
          {"FrictionOrder", friction_order},
          {"Added", added},
          {"OtherUnits", other_units}};
}

}  // namespace grader::h9

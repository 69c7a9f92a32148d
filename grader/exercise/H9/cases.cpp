// STAFF ONLY.
#include "grader/exercise/H9/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h9 {

WholeRunPoints whole_run() {
  return {2, 2};
}

std::vector<Category> categories() {
  return {{"Strengths", "The strength of a link", 1, strengths},
          {"Histories", "Links that never heal", 2, histories},
          {"LinkEnergies", "Energies of new links", 1, link_energies},
          {"LinkForces", "Forces of new links", 1, link_forces},
          {"TurnedFrames", "Frames that turn", 3, turned_frames},
          {"WornLinks", "Worn and broken links", 2, worn_links},
          {"LinkProducts", "Products of new links", 1, link_products},
          {"Touches", "Points near triangles", 2, touches},
          {"Weights", "Hairs that cross or merge", 2, weights},
          {"StripForces", "Energies and forces of strips", 2, strip_forces},
          {"StripProducts", "Products of strips", 1, strip_products},
          {"Frictions", "Friction", 2, frictions}};
}

}  // namespace grader::h9

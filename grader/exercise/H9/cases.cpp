// STAFF ONLY. The categories of H9 and their weights.
#include "grader/exercise/H9/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h9 {

WholeRunPoints whole_run() {
  return {1, 1};
}

std::vector<Category> categories() {
  return {{"Strengths", "The strength of a link", 1, strengths},
          {"Histories", "Links that never heal", 1, histories},
          {"LinkEnergies", "Energies of links", 1, link_energies},
          {"LinkForces", "Forces of links", 2, link_forces},
          {"TurnedFrames", "Frames that turn", 1, turned_frames},
          {"WornLinks", "Worn and broken links", 1, worn_links},
          {"LinkProducts", "Products of links", 1, link_products},
          {"Touches", "Points near triangles", 2, touches},
          {"FlatTriangles", "Triangles without an area", 1, flat_triangles},
          {"Weights", "Hairs that cross or merge", 1, weights},
          {"NoDirections", "Hairs without a direction", 1, no_directions},
          {"StripForces", "Energies and forces of strips", 2, strip_forces},
          {"StripProducts", "Products of strips", 1, strip_products},
          {"Frictions", "Friction", 2, frictions},
          {"PinnedFrictions", "Friction where nothing slips or moves", 1, pinned_frictions},
          {"FrictionOrder", "Friction, contact after contact", 1, friction_order},
          {"Added", "Added to what is there", 1, added},
          {"OtherUnits", "Hair of any size and weight", 1, other_units}};
}

}  // namespace grader::h9

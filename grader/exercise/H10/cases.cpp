// STAFF ONLY. The categories of H10 and their points.
#include "grader/exercise/H10/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h10 {

WholeRunPoints whole_run() {
  return {1, 1};
}

std::vector<Category> categories() {
  return {{"WeightsInside", "Weights inside of a triangle", 2, weights_inside},
          {"WeightsOutside", "Weights outside of a triangle", 2, weights_outside},
          {"ThinTriangles", "Thin triangles", 1, thin_triangles},
          {"NoWidth", "Triangles without a width", 1, no_width},
          {"FlatScalp", "Interpolation on a flat scalp", 2, flat_scalp},
          {"CurvedScalp", "Interpolation in root frames", 3, curved_scalp},
          {"Arcs", "Arc parameters", 1, arcs},
          {"CarriedTurns", "Frames carried along a guide", 4, carried_turns},
          {"Folds", "Folds, and points that coincide", 1, folds},
          {"Wisps", "Wisps that keep their width", 2, wisps},
          {"Spreading", "Wisps that spread or close", 1, spreading},
          {"Blends", "Blends", 1, blends},
          {"Units", "Any unit of length", 1, other_units}};
}

}  // namespace grader::h10

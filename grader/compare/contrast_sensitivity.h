// STAFF ONLY. The resolution of the eye: the contrast sensitivity S(f) = sum of a exp(-b f^2), f in cycles
// per degree, as a filter in the plane. Source of the constants: the paper on FLIP, see flip.h.
#pragma once

#include "grader/compare/plane.h"

namespace grader::inline compare {

enum class Opponent { achromatic, red_green, blue_yellow };

// Filters a channel of Y_y C_x C_z as the eye does. A uniform channel does not change.
Plane seen(const Plane& channel, Opponent opponent, double pixels_per_degree);

}  // namespace grader::compare

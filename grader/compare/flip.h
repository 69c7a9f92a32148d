// STAFF ONLY. How different two pictures look to a person who flips between them: LDR-FLIP. Source: P.
// Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom and M. D. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques
// 3(2), 2020.
//
// Two pipelines meet. Colour: what the eye can't resolve at this distance is filtered away, what is left is
// compared in a uniform colour space. Features: edges and points that are in one picture only. In each pixel
// FLIP = colour^(1 - feature).
#pragma once

#include "grader/compare/plane.h"
#include "hair/io/image/image.h"

namespace grader {

using ErrorMap = Plane;  // 0 (no difference) to 1

// Half a metre and more from a screen of 0.25 mm a pixel.
inline constexpr double kPixelsPerDegree = 67;

// Both of the same size, and 1 to 1000 pixels per degree, else std::invalid_argument. It is symmetric.
ErrorMap flip(const hair::Image& reference, const hair::Image& test,
              double pixels_per_degree = kPixelsPerDegree);

}  // namespace grader

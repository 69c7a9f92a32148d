// STAFF ONLY. LDR-FLIP: the visible difference of two pictures for a person who flips between them. Source:
// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom and M. D. Fairchild, "FLIP: A
// Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive
// Techniques
// 3(2), 2020.
//
// FLIP combines two pipelines. Colour: details below the eye's resolution at this distance are filtered out,
// and the rest is compared in a uniform colour space. Features: edges and points that only one picture has.
// In each pixel FLIP = colour^(1 - feature).
#pragma once

#include "grader/compare/plane.h"
#include "hair/io/image/image.h"

namespace grader::inline compare {

using ErrorMap = Plane;  // 0 (no difference) to 1

// Assumes a viewing distance of about 0.96 m from a screen with 0.25 mm pixels.
inline constexpr double kPixelsPerDegree = 67;

// Both pictures must have the same size, and pixels_per_degree must be 1 to 1000, else throws
// std::invalid_argument. FLIP is symmetric.
ErrorMap flip(const hair::Image& reference, const hair::Image& test,
              double pixels_per_degree = kPixelsPerDegree);

}  // namespace grader::compare

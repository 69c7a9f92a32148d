// STAFF ONLY. How different two pictures look to a person who flips between them: LDR-FLIP. Source: P.
// Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom and M. D. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques
// 3(2), 2020.
#pragma once

#include <vector>

#include "hair/image/image.h"

namespace grader {

// A number for each pixel, rows from the top down.
struct ErrorMap {
  int width = 0, height = 0;
  std::vector<float> values;
};

inline constexpr double kPixelsPerDegree = 67;

// 0 (no difference) to 1. Both of the same size, else std::invalid_argument.
ErrorMap flip(const hair::Image& reference, const hair::Image& test,
              double pixels_per_degree = kPixelsPerDegree);

}  // namespace grader

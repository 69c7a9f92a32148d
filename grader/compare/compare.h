// STAFF ONLY. The distance between two pictures, as numbers.
//
// If a thin strand moves by one pixel, all of its pixels are wrong, but it looks the same. The blurred RMSE
// ignores such shifts. FLIP measures the difference that a person sees who flips between the two pictures,
// including a moved strand.
#pragma once

#include "grader/compare/flip.h"

namespace grader::inline compare {

inline constexpr double kBlur = 4;  // px, sigma of the Gaussian

// Limit the distances of a right run's pictures.
inline constexpr double kBlurredRmse = 0.0005, kFlip = 0.001;

struct PictureDistance {
  // Is the root mean square, over pixels and channels, of the difference of the pictures blurred by kBlur:
  // from 0 to 1, which is black against white. It uses the encoded values, 0 to 1: equal steps of them look
  // about equally large, so that hair in the shadow counts as much as hair in the light.
  double blurred_rmse = 0;
  double flip_mean = 0, flip_max = 0;
  bool identical = false;  // byte for byte
};

// Both pictures must have the same size, else throws std::invalid_argument. The distance is symmetric.
PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test);

// Does the same, with a FLIP map that was already computed.
PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test, const ErrorMap& map);

}  // namespace grader::compare

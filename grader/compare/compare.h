// STAFF ONLY. How far a picture is from another, as numbers.
//
// A thin strand that moves by a pixel is wrong in all of its pixels, and yet looks the same. The blurred RMSE
// looks past that. FLIP tells what a person sees who flips between the two, a moved strand included.
#pragma once

#include "grader/compare/flip.h"

namespace grader {

inline constexpr double kBlur = 4;  // px, sigma of the Gaussian

struct PictureDistance {
  // The root mean square, over pixels and channels, of the difference of the pictures blurred by kBlur: 0, to
  // 1 for black and white. Of the values as they are encoded, 0 to 1: equal steps of these look about equally
  // large, so that hair in the shadow counts as hair in the light does.
  double blurred_rmse = 0;
  double flip_mean = 0, flip_max = 0;
  bool identical = false;  // byte for byte
};

// Both of the same size, else std::invalid_argument. It is symmetric.
PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test);

// The same of a map of FLIP that is at hand.
PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test, const ErrorMap& map);

}  // namespace grader

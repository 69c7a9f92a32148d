// STAFF ONLY. How far a picture is from another, as numbers and as a heat map.
#pragma once

#include "grader/compare/flip.h"

namespace grader {

inline constexpr double kBlur = 4;  // px, sigma of the Gaussian

struct PictureDistance {
  double blurred_rmse = 0;  // of the pictures blurred by kBlur, 0 to 1 (1: black and white)
  double flip_mean = 0, flip_max = 0;
  bool identical = false;  // byte for byte
};

// Both of the same size, else std::invalid_argument.
PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test);

// A map of errors from 0 (dark) to 1 (bright).
hair::Image heat_map(const ErrorMap& map);

// Whether two pictures of the same geometry may come from two machines: equal, or at most 0.05 % of the
// pixels are off by more than 2 in a channel, and the RMSE is at most 0.5 / 255.
bool same_on_another_machine(const hair::Image& a, const hair::Image& b);

}  // namespace grader

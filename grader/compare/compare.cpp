// STAFF ONLY. Computes the distances of two pictures.
#include "grader/compare/compare.h"

#include <algorithm>
#include <cmath>

namespace grader::inline compare {
namespace {

// Blurring is linear: the difference of blurred pictures is the blurred difference.
double blurred_rmse(const hair::Image& a, const hair::Image& b) {
  const Kernel kernel = gaussian(kBlur, static_cast<int>(3 * kBlur));
  double squares = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    Plane difference(a.width, a.height);
    for (std::size_t i = 0; i < difference.values.size(); ++i)
      difference.values[i] =
          static_cast<float>(int{a.pixels[3 * i + channel]} - int{b.pixels[3 * i + channel]}) / 255;
    for (const float value : filtered(difference, kernel, kernel).values) squares += double{value} * value;
  }
  return a.pixels.empty() ? 0 : std::sqrt(squares / static_cast<double>(a.pixels.size()));
}

}  // namespace

PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test) {
  return compare_pictures(reference, test, flip(reference, test));
}

PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test, const ErrorMap& map) {
  PictureDistance distance;
  distance.identical = reference == test;
  distance.blurred_rmse = blurred_rmse(reference, test);
  double sum = 0;
  for (const float value : map.values) {
    sum += value;
    distance.flip_max = std::max(distance.flip_max, double{value});
  }
  distance.flip_mean = map.values.empty() ? 0 : sum / static_cast<double>(map.values.size());
  return distance;
}

}  // namespace grader::compare

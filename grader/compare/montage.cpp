// STAFF ONLY. Puts pictures side by side, makes them smaller, and colours errors.
#include "grader/compare/montage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace grader::inline compare {
namespace {

using hair::Image;

constexpr int kGap = 8;  // px

// Returns the share of a pixel between two numbers.
double covered(int pixel, double from, double to) {
  return std::max(0.0, std::min(to, pixel + 1.0) - std::max(from, static_cast<double>(pixel)));
}

// Shortens the rows of a channel, and turns it: it is called twice, for rows and for columns.
Plane shortened_and_turned(const Plane& in, int width) {
  const double scale = static_cast<double>(in.width) / width;
  Plane out(in.height, width);
  for (int x = 0; x < width; ++x) {
    const double from = x * scale, to = (x + 1) * scale;
    const int last = std::min(in.width - 1, static_cast<int>(to));
    for (int y = 0; y < in.height; ++y) {
      double sum = 0;
      for (int i = static_cast<int>(from); i <= last; ++i) sum += covered(i, from, to) * in.row(y)[i];
      out.row(x)[y] = static_cast<float>(sum / scale);
    }
  }
  return out;
}

// Clamps to 0..1.
HeatColor heat_color(double value) {
  const double at = std::clamp(value, 0.0, 1.0) * (kHeatColors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), kHeatColors.size() - 2);
  const double share = at - static_cast<double>(below);
  HeatColor color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(
        std::lround((1 - share) * kHeatColors[below][c] + share * kHeatColors[below + 1][c]));
  return color;
}

}  // namespace

Image side_by_side(const std::vector<Image>& images) {
  if (images.empty()) throw std::invalid_argument("side_by_side: no picture; it needs at least one");
  Image all{-kGap, images.front().height, {}};
  for (const Image& image : images) {
    if (image.height != all.height)
      throw std::invalid_argument("side_by_side: pictures " + std::to_string(all.height) + " and " +
                                  std::to_string(image.height) + " pixels high; they must be equally high");
    all.width += image.width + kGap;
  }
  for (int y = 0; y < all.height; ++y)
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (i > 0) all.pixels.insert(all.pixels.end(), 3 * kGap, 24);
      const std::uint8_t* row = images[i].at(0, y);
      all.pixels.insert(all.pixels.end(), row, row + 3 * static_cast<std::ptrdiff_t>(images[i].width));
    }
  return all;
}

Image shrunk(const Image& image, int width) {
  if (image.width <= width || width < 1) return image;
  const int height =
      std::max(1, static_cast<int>(std::lround(static_cast<double>(image.height) * width / image.width)));
  Image result{width, height, {}};
  result.pixels.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t c = 0; c < 3; ++c) {
    Plane channel(image.width, image.height);
    for (std::size_t i = 0; i < channel.values.size(); ++i) channel.values[i] = image.pixels[3 * i + c];
    const Plane small = shortened_and_turned(shortened_and_turned(channel, width), height);
    for (std::size_t i = 0; i < small.values.size(); ++i)
      result.pixels[3 * i + c] = static_cast<std::uint8_t>(std::lround(small.values[i]));
  }
  return result;
}

Image heat_map(const Plane& map) {
  Image image{map.width, map.height, {}};
  image.pixels.reserve(3 * map.values.size());
  for (const float value : map.values)
    for (const std::uint8_t channel : heat_color(value)) image.pixels.push_back(channel);
  return image;
}

}  // namespace grader::compare

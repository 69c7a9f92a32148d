// STAFF ONLY. Median cut, and PNG files with a palette.
#include "grader/compare/palette.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <stdexcept>

namespace grader {
namespace {

using Pixel = std::array<std::uint8_t, 3>;

struct UsedColor {
  Pixel color;
  std::size_t number = 0;  // in order of first occurrence
  double count = 0, weight = 0;
};

// Colours that become one, and where they would be cut: the channel in which they are furthest apart, its mean.
struct Box {
  std::span<UsedColor> colors;
  std::size_t channel = 0;
  double mean = 0, spread = 0;
};

Box box_of(std::span<UsedColor> colors) {
  Box box{colors};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double weight = 0, sum = 0, spread = 0;
    for (const UsedColor& used : colors) {
      weight += used.weight;
      sum += used.weight * used.color[channel];
    }
    const double mean = sum / weight;
    for (const UsedColor& used : colors)
      spread += used.weight * (used.color[channel] - mean) * (used.color[channel] - mean);
    if (spread > box.spread) box = {colors, channel, mean, spread};
  }
  return colors.size() > 1 ? box : Box{colors};  // one colour is at its mean but for roundings
}

Pixel mean_of(std::span<const UsedColor> colors) {
  std::array<double, 3> sum{};
  double count = 0;
  for (const UsedColor& used : colors) {
    count += used.count;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += used.count * used.color[c];
  }
  Pixel mean{};
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>(std::lround(sum[c] / count));
  return mean;
}

}  // namespace

PalettePicture in_few_colors(const hair::Image& image, std::size_t most) {
  const std::size_t pixels = image.pixels.size() / 3;
  if (most < 1 || most > 256 || pixels == 0)
    throw std::invalid_argument("a picture of " + std::to_string(pixels) + " pixels in " +
                                std::to_string(most) +
                                " colours; it takes one pixel at least, and 1 to 256 colours");
  const auto color_at = [&](std::size_t i) -> Pixel {
    return {image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]};
  };
  std::vector<UsedColor> used;
  std::vector<std::size_t> numbers;  // of the pixels' colours
  numbers.reserve(pixels);
  std::map<Pixel, std::size_t> number_of;
  for (std::size_t i = 0; i < pixels; ++i) {
    const Pixel color = color_at(i);
    if (i > 0 && color == color_at(i - 1)) {  // as most are
      numbers.push_back(numbers.back());
    } else {
      const auto [found, is_new] = number_of.try_emplace(color, used.size());
      if (is_new) used.push_back({color, used.size()});
      numbers.push_back(found->second);
    }
    ++used[numbers.back()].count;
  }
  for (UsedColor& one : used) one.weight = std::sqrt(one.count);

  std::vector<Box> boxes{box_of(used)};
  while (boxes.size() < most) {
    const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                         [](const Box& a, const Box& b) { return a.spread < b.spread; });
    if (widest->spread == 0) break;
    const Box box = *widest;
    const auto upper = std::stable_partition(box.colors.begin(), box.colors.end(), [&](const UsedColor& one) {
      return one.color[box.channel] <= box.mean;
    });
    *widest = box_of({box.colors.begin(), upper});
    boxes.push_back(box_of({upper, box.colors.end()}));
  }

  PalettePicture picture{image.width, image.height, {}, {}};
  std::vector<std::uint8_t> place(used.size());  // in the palette, by number
  for (const Box& box : boxes) {
    for (const UsedColor& one : box.colors)
      place[one.number] = static_cast<std::uint8_t>(picture.colors.size());
    picture.colors.push_back(mean_of(box.colors));
  }
  picture.pixels.reserve(pixels);
  for (const std::size_t number : numbers) picture.pixels.push_back(place[number]);
  return picture;
}

std::string encode_palette_png(const PalettePicture& picture) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(picture.width);
  png.height = static_cast<png_uint_32>(picture.height);
  png.format = PNG_FORMAT_RGB_COLORMAP;
  png.colormap_entries = static_cast<png_uint_32>(picture.colors.size());
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, picture.pixels.data(), 0,
                                picture.colors.data()) == 0)
    throw std::runtime_error(std::string("libpng does not write a picture: ") + png.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace grader

// STAFF ONLY.
#include "grader/compare/palette.h"

#include <zlib.h>

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

std::string big_endian(std::size_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

const Bytef* as_bytes(const std::string& text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string checked = type + data;
  return big_endian(data.size()) + checked +
         big_endian(crc32(0, as_bytes(checked), static_cast<uInt>(checked.size())));
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, as_bytes(bytes), bytes.size(),
                Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib does not compress " + std::to_string(bytes.size()) + " bytes");
  out.resize(size);
  return out;
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

// PNG (Second Edition, W3C 2003), sections 5.2, 11.2: colour type 3, eight bits, no filter.
std::string encode_palette_png(const PalettePicture& picture) {
  std::string colors, rows;
  for (const Pixel& color : picture.colors) colors.append(color.begin(), color.end());
  const auto width = static_cast<std::size_t>(picture.width);
  for (std::size_t at = 0; at < picture.pixels.size(); at += width) {
    rows += '\0';
    rows.append(picture.pixels.begin() + static_cast<std::ptrdiff_t>(at),
                picture.pixels.begin() + static_cast<std::ptrdiff_t>(at + width));
  }
  const std::string kind{8, 3, 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", big_endian(width) + big_endian(static_cast<std::size_t>(picture.height)) + kind) +
         chunk("PLTE", colors) + chunk("IDAT", deflated(rows)) + chunk("IEND", "");
}

}  // namespace grader

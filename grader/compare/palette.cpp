// STAFF ONLY. Merges colours in a cell of a grid, and writes PNG files with a palette.
#include "grader/compare/palette.h"

#include <png.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace grader::inline compare {
namespace {

using Pixel = std::array<std::uint8_t, 3>;

struct Cell {
  std::array<double, 3> sum = {};
  double pixels = 0;
  std::uint8_t number = 0;
};

}  // namespace

PalettePicture in_few_colors(const hair::Image& image, std::size_t most) {
  const std::size_t pixels = image.pixels.size() / 3;
  if (most < 1 || most > 256 || pixels == 0)
    throw std::invalid_argument("a picture of " + std::to_string(pixels) + " pixels in " +
                                std::to_string(most) +
                                " colours; it takes one pixel at least, and 1 to 256 colours");
  std::map<Pixel, Cell> cells;
  std::vector<Cell*> cell_of(pixels);
  for (int side = 1; side == 1 || cells.size() > most; ++side) {
    cells.clear();
    Pixel last{};
    for (std::size_t i = 0; i < pixels; ++i) {
      Pixel place{};
      for (std::size_t c = 0; c < 3; ++c)
        place[c] = static_cast<std::uint8_t>(image.pixels[3 * i + c] / side);
      Cell& cell = i > 0 && place == last ? *cell_of[i - 1] : cells[place];  // most repeat the last one
      for (std::size_t c = 0; c < 3; ++c) cell.sum[c] += image.pixels[3 * i + c];
      ++cell.pixels;
      cell_of[i] = &cell;
      last = place;
    }
  }

  PalettePicture picture{image.width, image.height, {}, {}};
  for (auto& [place, cell] : cells) {
    cell.number = static_cast<std::uint8_t>(picture.colors.size());
    Pixel& mean = picture.colors.emplace_back();
    for (std::size_t c = 0; c < 3; ++c)
      mean[c] = static_cast<std::uint8_t>(std::lround(cell.sum[c] / cell.pixels));
  }
  for (const Cell* cell : cell_of) picture.pixels.push_back(cell->number);
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

}  // namespace grader::compare

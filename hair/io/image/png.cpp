#include "hair/io/image/png.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>
#include <stdexcept>

#ifdef HAIR_ZLIB
#include <zlib.h>

// Returns null if memory runs out. stb frees the result.
static unsigned char* compressed(unsigned char* bytes, int count, int* size, int level) {
  uLongf most = compressBound(static_cast<uLong>(count));
  auto* const out = static_cast<unsigned char*>(std::malloc(most));
  if (out == nullptr || compress2(out, &most, bytes, static_cast<uLong>(count), level) != Z_OK) {
    std::free(out);
    return nullptr;
  }
  *size = static_cast<int>(most);
  return out;
}
#define STBIW_ZLIB_COMPRESS compressed
#endif

// stb's names stay in this file: other libraries may have them, too.
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace hair {
namespace {

// True if 17 of 20 pixels are as their neighbours: such a picture is smallest without a filter, a shaded one
// with those that stb chooses.
bool is_flat(const Image& image) {
  std::size_t equal = 0;
  for (std::size_t i = 3; i < image.pixels.size(); i += 3)
    equal += std::equal(&image.pixels[i - 3], &image.pixels[i], &image.pixels[i]) ? 1 : 0;
  return 3 * equal > image.pixels.size() / 20 * 17;
}

}  // namespace

std::string encode_png(const Image& image) {
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.width > kMostSide || image.height > kMostSide ||
      pixels > kMostPixels || image.pixels.size() != 3 * pixels) {
    throw std::invalid_argument("a picture of " + std::to_string(image.width) + " x " +
                                std::to_string(image.height) + " pixels with " +
                                std::to_string(image.pixels.size()) +
                                " bytes; it must have 1 to 16384 a side and three bytes for each");
  }
  std::string bytes;
  const auto append = [](void* all, void* part, int count) {
    static_cast<std::string*>(all)->append(static_cast<const char*>(part), static_cast<std::size_t>(count));
  };
  const bool flat = is_flat(image);
  static std::mutex turns;  // stb reads its filter from a variable
  const std::lock_guard turn(turns);
  stbi_write_force_png_filter = flat ? 0 : -1;
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.pixels.data(),
                             3 * image.width) == 0)
    throw std::bad_alloc();
  return bytes;
}

}  // namespace hair

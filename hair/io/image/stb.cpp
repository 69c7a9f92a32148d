#include "hair/io/image/stb.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_FAILURE_STRINGS
#include <stb_image.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace hair {
namespace {

void append(void* text, void* bytes, int count) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(count));
}

}  // namespace

StbPicture stb_decode_png(std::string_view bytes) {
  StbPicture picture;
  int channels = 0;
  std::uint8_t* const rgba =
      stbi_load_from_memory(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                            static_cast<int>(bytes.size()), &picture.width, &picture.height, &channels, 4);
  if (rgba == nullptr) {
    picture.why_not = "its data are damaged or of a kind that is not known";
    return picture;
  }
  const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.rgba.assign(rgba, rgba + 4 * pixels);
  stbi_image_free(rgba);
  return picture;
}

bool stb_inflates(std::string_view zlib, std::size_t most) {
  std::string out(most, '\0');
  return stbi_zlib_decode_buffer(out.data(), static_cast<int>(most), zlib.data(),
                                 static_cast<int>(zlib.size())) >= 0;
}

std::string stb_encode_png(int width, int height, const std::uint8_t* rgb) {
  std::string bytes;
  stbi_write_png_to_func(append, &bytes, width, height, 3, rgb, 3 * width);
  return bytes;
}

}  // namespace hair

// The used parts of stb_image and stb_image_write. Only stb.cpp compiles them, so that their names can't
// clash with those of another library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

// Four bytes a pixel, or the reason why not. Decoding allocates memory for the header's size and for the
// inflated data.
struct StbPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  std::string why_not;
};
StbPicture stb_decode_png(std::string_view bytes);

// Whether the zlib data are complete and inflate to at most `most` bytes.
bool stb_inflates(std::string_view zlib, std::size_t most);

std::string stb_encode_png(int width, int height, const std::uint8_t* rgb);

}  // namespace hair

// What is used of stb_image and stb_image_write. They are compiled in stb.cpp alone, and their names can't
// meet another library's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

// Four bytes a pixel, or the reason why not: memory is taken for what the header says, and for what its data
// inflate to.
struct StbPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  std::string why_not;
};
StbPicture stb_decode_png(std::string_view bytes);

// Whether zlib's data are whole and inflate to at most that many bytes.
bool stb_inflates(std::string_view zlib, std::size_t most);

std::string stb_encode_png(int width, int height, const std::uint8_t* rgb);

}  // namespace hair

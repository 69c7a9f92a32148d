#include "hair/io/image/same_picture.h"

#include <cstdlib>

namespace hair {

bool same_on_another_machine(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) return false;
  std::size_t off = 0, squares = 0;
  for (std::size_t i = 0; i + 2 < a.pixels.size(); i += 3) {
    bool is_off = false;
    for (std::size_t c = i; c < i + 3; ++c) {
      const int difference = std::abs(int{a.pixels[c]} - int{b.pixels[c]});
      is_off = is_off || difference > 2;
      squares += static_cast<std::size_t>(difference * difference);
    }
    off += is_off;
  }
  const std::size_t pixels = a.pixels.size() / 3;
  return off * 2000 <= pixels && 4 * squares <= 3 * pixels;
}

}  // namespace hair

// STAFF ONLY. Montages of pictures, and shrunk pictures.
#pragma once

#include <vector>

#include "hair/io/image/image.h"

namespace grader::inline compare {

// Puts pictures from left to right with a dark line between them. At least one picture, and all of the same
// height, else throws std::invalid_argument.
hair::Image side_by_side(const std::vector<hair::Image>& images);

// At most `width` pixels wide, with the same aspect ratio: each pixel is the mean of the pixels that it
// covers. A narrower picture stays unchanged.
hair::Image shrunk(const hair::Image& image, int width);

}  // namespace grader::compare

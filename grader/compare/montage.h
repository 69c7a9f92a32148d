// STAFF ONLY. Puts pictures side by side, and shrinks them.
#pragma once

#include <vector>

#include "hair/io/image/image.h"

namespace grader::inline compare {

// A picture of this width, a tenth of those that are measured, is what students may see of what is far from
// the reference's.
inline constexpr int kCoarseWidth = 48, kCoarseHeight = 27;  // pixels

// Puts pictures from left to right with a dark line between them. There must be at least one picture, and all
// must have the same height, else it throws std::invalid_argument.
hair::Image side_by_side(const std::vector<hair::Image>& images);

// Makes a picture at most `width` pixels wide, with the same aspect ratio: each pixel is the mean of the
// pixels that it covers. A narrower picture stays unchanged.
hair::Image shrunk(const hair::Image& image, int width);

}  // namespace grader::compare

// STAFF ONLY. Pictures put together, and made small.
#pragma once

#include <vector>

#include "hair/io/image/image.h"

namespace grader {

// From left to right with a dark line between them. All of the same height, at least one, else
// std::invalid_argument.
hair::Image side_by_side(const std::vector<hair::Image>& images);

// At most `width` pixels wide, its sides as they were to each other: each pixel is the mean of what it
// covers. A picture that is narrower stays as it is.
hair::Image shrunk(const hair::Image& image, int width);

}  // namespace grader

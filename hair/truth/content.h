// A problem's content as a short text: two problems with the same text have the same motion.
#pragma once

#include <string>

#include "hair/truth/problem.h"

namespace hair {

// 16 hexadecimal digits, a digest of every number that the problem's motion depends on, bit by bit:
// particles, forces, roots, moments. It excludes the name, and the method, step and tolerance.
std::string content_of(const Problem& problem);

}  // namespace hair

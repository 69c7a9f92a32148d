// What a problem is, as a short text: two problems with the same text move in the same way.
#pragma once

#include <string>

#include "hair/truth/problem.h"

namespace hair {

// 16 hexadecimal digits, made of every number that the problem's motion depends on, bit by bit: particles,
// forces, roots, moments. Not of its name, and not of how it is moved: method, step, tolerance.
std::string content_of(const Problem& problem);

}  // namespace hair

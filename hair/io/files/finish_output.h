// The beginning and the end of a program that prints its results.
#pragma once

#include <string>

namespace hair {

// Call this first in a program. If a standard descriptor is closed (>&-), the next opened file gets its
// number, and printed text would go into that file. This function occupies such numbers, so that printing to
// them fails.
void begin_output();

// Writes the rest of std::cout. Returns `code`; if any printed text got lost (a full disk, a reader that is
// gone), reports it in a line that begins with the program's name, and returns 2 instead of 0.
int finish_output(const std::string& program, int code);

}  // namespace hair

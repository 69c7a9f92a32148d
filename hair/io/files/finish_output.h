// The beginning and the end of a program that prints its results.
#pragma once

#include <string>

namespace hair {

// Before anything else. The next file that is opened gets the number of a standard descriptor that is closed
// (>&-), and would be written what is printed. Here such a number is taken, and nothing can be printed there.
void begin_output();

// Writes what std::cout still holds. Returns `code`; if anything that was printed got lost (a full disk, a
// reader that is gone), complains in a line that begins with the program's name, and returns 2 in the place
// of 0.
int finish_output(const std::string& program, int code);

}  // namespace hair

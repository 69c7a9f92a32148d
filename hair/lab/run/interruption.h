// Handles Ctrl-C: long work stops cleanly and keeps finished results.
#pragma once

#include <atomic>

namespace hair {

// From now on the first SIGINT, SIGTERM or SIGHUP sets the returned flag and prints `message`; the second one
// ends the program at once. Writing to a closed pipe or beyond a file size limit returns an error instead of
// ending the program. `message` must live as long as the program.
const std::atomic<bool>& catch_interruption(const char* message);

}  // namespace hair

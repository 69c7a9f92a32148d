// Ctrl-C: long work ends in order and keeps what is finished.
#pragma once

#include <atomic>

namespace hair {

// From now on SIGINT, SIGTERM and SIGHUP set what is returned, the second time they end the program at once. Writing
// to a closed pipe or beyond a file's limit fails, and says why, instead of ending it. `message` is what a person is
// told the first time; it must live as long as the program.
const std::atomic<bool>& catch_interruption(const char* message);

}  // namespace hair

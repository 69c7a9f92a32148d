// STAFF ONLY. The present request of a worker, and its pipes, for events in the middle of student code.
#pragma once

#include <cstdint>

#include "grader/worker/session.h"

namespace grader::inline worker {

inline constexpr int kIn = 3, kOut = 4;

struct Current {
  std::uint64_t nonce = 0;
};

inline Current current;

// Runs it on a stack whose ends AddressSanitizer knows: if an exception unwinds it, the runtime must clear
// its marks there. The main thread's ends are in /proc, which no sandbox has. Only the worker with sanitizers
// has this function.
__attribute__((weak)) void run_on_known_stack(void (*run)());

}  // namespace grader::worker

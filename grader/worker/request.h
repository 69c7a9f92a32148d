// STAFF ONLY. The request that a worker is at, and its pipes: for what can happen in the middle of student
// code.
#pragma once

#include <cstdint>

#include "grader/worker/session.h"

namespace grader::inline worker {

inline constexpr int kIn = 3, kOut = 4;

struct Current {
  std::uint64_t nonce = 0;
};

inline Current current;

// Runs it on a stack whose ends AddressSanitizer knows: where an exception unwinds it, the runtime must
// forget what it had marked there. The main thread's ends stand in /proc, which no sandbox has. Only in the
// worker with sanitizers.
__attribute__((weak)) void run_on_known_stack(void (*run)());

}  // namespace grader::worker

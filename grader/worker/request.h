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

}  // namespace grader::worker

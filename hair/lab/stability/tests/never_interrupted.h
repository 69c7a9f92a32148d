// STAFF ONLY. A flag for studies that run to their end.
#pragma once

#include <atomic>

namespace reference_tests {

inline const std::atomic<bool> kNeverInterrupted = false;

}  // namespace reference_tests

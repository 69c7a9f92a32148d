// The processor's time of this thread: what a measurement takes, whatever else runs beside it.
#pragma once

#include <ctime>

namespace hair {

inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace hair

// STAFF ONLY.
#include "grader/sandbox/watchdog.h"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <chrono>

namespace grader {

bool Watchdog::wait_for(int descriptor, short events) {
  using Clock = std::chrono::steady_clock;
  constexpr int kLookEvery = 250;  // milliseconds
  pollfd wanted{descriptor, events, 0};
  CagedProcess::Activity last = {};
  bool looked = false;
  for (auto start = Clock::now();;) {
    const int ready = poll(&wanted, 1, kLookEvery);
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    start = Clock::now();
    waited_ += elapsed;
    if (ready < 0 && errno != EINTR) return false;
    if (ready == 0) {
      const CagedProcess::Activity now = process_.activity();
      // Threads of its own may compute while the first one waits for them.
      if (looked && !now.wants_to_run) idle_ += std::max(0.0, elapsed - (now.cpu_seconds - last.cpu_seconds));
      last = now;
      looked = true;
    }
    if (idle_ > patience_.idle_seconds || waited_ > patience_.total_seconds) {
      waited_in_vain_ = true;
      return false;
    }
    if (ready > 0) return true;
  }
}

}  // namespace grader

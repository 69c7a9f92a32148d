// STAFF ONLY.
#include "grader/suite/watchdog.h"

#include <poll.h>

#include <cerrno>
#include <chrono>

namespace grader {

bool Watchdog::wait_for(int descriptor, short events) {
  using Clock = std::chrono::steady_clock;
  constexpr int kLookEvery = 250;  // milliseconds
  pollfd wanted{descriptor, events, 0};
  CagedProcess::Activity last;
  bool looked = false;
  double asleep = 0;
  for (auto start = Clock::now();;) {
    const int ready = poll(&wanted, 1, kLookEvery);
    const double waited = std::chrono::duration<double>(Clock::now() - start).count();
    start = Clock::now();
    total_waited_ += waited;
    if (ready < 0 && errno != EINTR) return false;
    if (ready == 0) {
      // Asleep at both ends, and at work for less than half of the time between: threads of its own may work while it waits for them.
      const CagedProcess::Activity now = process_.activity();
      const bool idle =
          looked && now.asleep && last.asleep && now.cpu_seconds - last.cpu_seconds < waited / 2;
      asleep = idle ? asleep + waited : 0;
      last = now;
      looked = true;
    }
    if (asleep > patience_.asleep_seconds || total_waited_ > patience_.total_seconds) {
      waited_in_vain_ = true;
      return false;
    }
    if (ready > 0) return true;
  }
}

}  // namespace grader

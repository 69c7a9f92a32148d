// STAFF ONLY.
#include "grader/sandbox/watchdog.h"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <fstream>

namespace grader {
namespace {

// What threads have computed and waited for a processor between two looks. Threads that have ended in between have
// computed, too: the process's own clock knows.
double busy_between(const CagedProcess::Activity& last, const CagedProcess::Activity& now) {
  double threads = 0;
  for (const auto& [thread, seconds] : now.busy_seconds) {
    const auto before = last.busy_seconds.find(thread);
    threads += seconds - (before == last.busy_seconds.end() ? 0 : before->second);
  }
  return std::max(threads, now.cpu_seconds - last.cpu_seconds);
}

// How long this thread has been ready to run without a processor. 0 if the kernel does not tell.
double own_delay_seconds() {
  std::ifstream file("/proc/thread-self/schedstat");
  double computed = 0, delayed = 0;
  file >> computed >> delayed;
  return file ? 1e-9 * delayed : 0;
}

}  // namespace

Watchdog::Watchdog(const CagedProcess& process, Patience patience)
    : process_(process), patience_(patience), own_delay_(own_delay_seconds()) {}

void Watchdog::look() {
  CagedProcess::Activity now = process_.activity();
  // Clocks of a process do not go back: this is another one, of those that made its cage.
  if (!now.alive || now.cpu_seconds < last_.cpu_seconds) return;
  const double own_delay = own_delay_seconds();
  started_ = started_ || now.started;
  if (started_ && !now.busy_seconds.empty())
    idle_ += std::max(0.0, waited_ - busy_between(last_, now) - (own_delay - own_delay_));
  own_delay_ = own_delay;
  waited_ = 0;
  last_ = std::move(now);
  if (idle_ > patience_.idle_seconds) why_ = "asleep";
  if (last_.cpu_seconds > patience_.cpu_seconds) why_ = "out of CPU time";
}

bool Watchdog::wait_for(int descriptor, short events) {
  constexpr double kWindow = 0.25;
  pollfd wanted{descriptor, events, 0};
  while (why_ == nullptr) {
    const Clock::time_point start = Clock::now();
    const int ready = poll(&wanted, 1, static_cast<int>(1000 * std::max(0.001, kWindow - waited_)));
    const Clock::time_point now = Clock::now();
    waited_ += std::chrono::duration<double>(now - start).count();
    if (ready < 0 && errno != EINTR) return false;
    if (waited_ >= kWindow) look();
    if (why_ == nullptr && std::chrono::duration<double>(now - start_).count() > patience_.wall_seconds)
      why_ = "out of time";
    if (ready > 0 && why_ == nullptr) return true;
  }
  return false;
}

}  // namespace grader

// STAFF ONLY. Looks at a worker while it waits, and sums up how long it idles.
#include "grader/sandbox/watchdog.h"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <thread>

namespace grader::inline sandbox {
namespace {

constexpr double kWindow = 0.25, kWindowAtTheEnd = 0.05;

// Waking up a sleeping process takes this long at most: the worker's and ours together, for each answer. No
// clock of the kernel counts it.
constexpr double kWakeUp = 50e-6;

// True if a thread has waited for a processor all the time: the kernel counts a wait only at its end.
bool waits(const SandboxedProcess::Activity::Busy& since, const SandboxedProcess::Activity& now) {
  const bool runnable =
      std::ranges::any_of(now.busy, [](const auto& thread) { return thread.second.runnable; });
  return runnable && since.computed <= 0 && since.queued <= 0;
}

// Returns how long this thread has been ready without a processor, or 0 if the kernel does not report it.
double own_delay_seconds() {
  std::ifstream file("/proc/thread-self/schedstat");
  double computed = 0, delayed = 0;
  file >> computed >> delayed;
  return file ? 1e-9 * delayed : 0;
}

}  // namespace

SandboxedProcess::Activity::Busy busy_between(const SandboxedProcess::Activity& last,
                                              const SandboxedProcess::Activity& now) {
  SandboxedProcess::Activity::Busy sum;
  for (const auto& [thread, busy] : now.busy) {
    const auto before = last.busy.find(thread);
    sum.computed += busy.computed - (before == last.busy.end() ? 0 : before->second.computed);
    sum.queued = std::max(sum.queued, busy.queued - (before == last.busy.end() ? 0 : before->second.queued));
  }
  sum.computed = std::max(sum.computed, now.cpu_seconds - last.cpu_seconds);
  return sum;
}

Watchdog::Watchdog(const SandboxedProcess& process, Patience patience)
    : process_(process), patience_(patience), own_delay_(own_delay_seconds()) {}

// A message shows that the worker's own code runs.
void Watchdog::greets() {
  if (!started_) waited_ = postponed_ = woken_ = 0;
  started_ = true;
}

void Watchdog::look() {
  SandboxedProcess::Activity now = process_.activity();
  // A started worker that is no longer found has ended; the process found in its place made its sandbox.
  if (!now.alive || (started_ && !now.started)) return;
  const SandboxedProcess::Activity::Busy busy = busy_between(last_, now);
  if (waits(busy, now)) {
    postponed_ = waited_;
    return;
  }
  const double own_delay = own_delay_seconds();
  started_ = now.started;
  if (started_ && !now.busy.empty()) {
    const double idle = waited_ - woken_ - busy.computed - busy.queued - (own_delay - own_delay_);
    // A wait for a processor that began before the last look is counted now, but was taken for idling then.
    idle_ = std::max(0.0, idle_ + std::max(idle, -busy.queued));
  }
  own_delay_ = own_delay;
  waited_ = postponed_ = woken_ = 0;
  last_ = std::move(now);
  if (idle_ > patience_.idle_seconds) why_ = "asleep";
  if (last_.cpu_seconds > patience_.cpu_seconds) why_ = "out of CPU time";
}

double Watchdog::most_cpu_seconds() const {
  return last_.cpu_seconds + waited_ * std::max(1U, std::thread::hardware_concurrency());
}

bool Watchdog::wait_for(int descriptor, short events) {
  return wait(descriptor, events, kWindow, patience_.wall_seconds);
}

void Watchdog::wait_for_end(double seconds) {
  look();
  if (seconds <= 0) return;
  const int handle = process_.handle();
  wait(handle, POLLIN, kWindowAtTheEnd, seconds);
}

bool Watchdog::wait(int descriptor, short events, double window, double most_seconds) {
  pollfd wanted{descriptor, events, 0};
  const double most = all_waited_ + most_seconds;
  while (why_ == nullptr && all_waited_ <= most) {
    const Clock::time_point start = Clock::now();
    const int ready =
        poll(&wanted, 1, static_cast<int>(1000 * std::max(0.001, postponed_ + window - waited_)));
    const Clock::time_point now = Clock::now();
    const double waited = std::chrono::duration<double>(now - start).count();
    waited_ += waited;
    all_waited_ += waited;
    if (ready > 0 && asked_ && (wanted.revents & POLLIN) != 0) {
      const double waking = std::min({waited, kWakeUp, patience_.wakeup_seconds - forgiven_});
      woken_ += waking;
      forgiven_ += waking;
      asked_ = false;
    }
    if (ready < 0 && errno != EINTR) return false;
    if (ready > 0 && (wanted.revents & POLLIN) != 0) greets();
    if (waited_ >= postponed_ + window) look();
    if (why_ == nullptr && all_waited_ > patience_.wall_seconds) why_ = "out of time";
    if (ready > 0 && why_ == nullptr) return true;
  }
  return false;
}

}  // namespace grader::sandbox

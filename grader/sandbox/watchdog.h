// STAFF ONLY. Waits for a worker, and decides when waiting is useless. Limits inside the sandbox bound a
// worker's CPU time by whole seconds; the watchdog bounds it more closely, and ends a worker that idles.
//
// It counts our waiting for the worker as idle, and subtracts the worker's computing, the longest time that
// one of its threads waits for a processor, our own wait for a processor after its answer, and the time in
// which two processes wake each other up: a whole run has ten thousands of answers. So a worker on a busy
// machine is not idle, and one that sleeps in short naps is. Waking up is forgiven once for each message that
// we sent, up to a bound: unasked messages excuse nothing. Waits of several threads at the same time count
// once. The sum is taken over windows of 0.25 s of waiting, and computing in one window hides no idling in
// another. A window lasts longer while a thread waits for a processor: the kernel counts a wait only at its
// end. The sum begins with the worker's own code: while its sandbox is made, the kernel's locks may delay us.
#pragma once

#include <chrono>

#include "grader/sandbox/sandboxed_process.h"

namespace grader::inline sandbox {

// Sums the computing of all threads between two looks, and takes the longest wait for a processor. The
// process's own clock includes threads that have ended.
SandboxedProcess::Activity::Busy busy_between(const SandboxedProcess::Activity& last,
                                              const SandboxedProcess::Activity& now);

class Watchdog {
 public:
  struct Patience {
    double idle_seconds = 3;
    double cpu_seconds = 10;
    double wakeup_seconds = 3;  // is the most that is forgiven
    // The longest wait for a worker, whatever it does and the kernel counts.
    double wall_seconds = 300;
  };

  Watchdog(const SandboxedProcess& process, Patience patience);

  // Waits until `descriptor` is ready for `events` (POLLIN, POLLOUT). False: the patience is used up.
  bool wait_for(int descriptor, short events);

  // The worker has got a message: it may take a moment to wake up.
  void asked() { asked_ = true; }

  // Waits for its end, for `seconds` at most, and looks more often: an ended process shows no idling.
  void wait_for_end(double seconds);

  bool waited_in_vain() const { return why_ != nullptr; }
  const char* why() const { return why_; }  // "asleep"; null while there is patience left

  // Looks once more, if the worker is still there.
  void look();

  // Returns the worker's time as last seen; our wait since then counts as computing.
  double idle_seconds() const { return idle_; }
  double wakeup_seconds() const { return forgiven_; }  // is forgiven so far
  double cpu_seconds() const { return last_.cpu_seconds + waited_; }
  // Assumes that it has computed on all processors since then.
  double most_cpu_seconds() const;

 private:
  using Clock = std::chrono::steady_clock;

  void greets();
  bool wait(int descriptor, short events, double window, double most_seconds);

  const SandboxedProcess& process_;
  Patience patience_;
  SandboxedProcess::Activity last_ = {};
  bool started_ = false, asked_ = false;
  double all_waited_ = 0;
  double waited_ = 0;     // counts from the last look
  double woken_ = 0;      // is the waking part of waited_, 50 us for each wait with an answer
  double forgiven_ = 0;   // is the sum of all woken_
  double postponed_ = 0;  // is the part of waited_ before a look without a result
  double own_delay_;      // belongs to this thread, at the last look
  double idle_ = 0;
  const char* why_ = nullptr;
};

}  // namespace grader::sandbox

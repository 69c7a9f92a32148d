// STAFF ONLY. Waits for a worker, and decides when waiting is useless. Limits inside the sandbox bound the
// CPU time of a worker by whole seconds; the watchdog bounds it more closely, and ends a worker that idles.
//
// Idle is the time that we wait for it less what it computes and less what the thread that waited most waited
// for a processor, whatever state the kernel calls them in, and less what we ourselves wait for one after its
// answer is there, and less what it takes two processes to wake each other up: a whole run has ten thousands
// of answers. So a worker on a busy machine is not idle, and one that sleeps in short naps is. Waking up is
// forgiven once for each message that we sent, and within a bound: messages that nobody asked for excuse
// nothing. Threads that wait for a processor at the same time wait once: thirty that wake each other up
// excuse no more than one does. The sum is taken over windows of 0.25 s of waiting, and what is computed in
// one hides no idling in another. A window is longer where a thread waits for a processor all through it: the
// kernel counts a wait when it is over. The sum begins when the worker's own code does: while its sandbox is
// made, the kernel's locks may have us wait for others.
#pragma once

#include <chrono>

#include "grader/sandbox/cage.h"

namespace grader::inline sandbox {

// Between two looks: how long all threads have computed, and how long the one that waited most has waited for
// a processor. Threads that have ended in between have computed, too: the process's own clock knows.
CagedProcess::Activity::Busy busy_between(const CagedProcess::Activity& last,
                                          const CagedProcess::Activity& now);

class Watchdog {
 public:
  struct Patience {
    double idle_seconds = 3;
    double cpu_seconds = 10;
    double wakeup_seconds = 3;  // that are forgiven in all
    // That we wait for it, whatever it does and whatever the kernel counts: the last fence.
    double wall_seconds = 300;
  };

  Watchdog(const CagedProcess& process, Patience patience);

  // Waits until `descriptor` is ready for `events` (POLLIN, POLLOUT). False: the patience is used up.
  bool wait_for(int descriptor, short events);

  // It has got a message: now it may take a moment to wake up.
  void asked() { asked_ = true; }

  // Waits for its end, for `seconds` at most, and looks more often: once it is gone nobody sees how it idled.
  void wait_for_end(double seconds);

  bool waited_in_vain() const { return why_ != nullptr; }
  const char* why() const { return why_; }  // "asleep"; null as long as there is patience left

  // Looks once more, if the worker is still there.
  void look();

  // What the worker has taken, as last seen; the time that we have waited for it since then counts as
  // computing.
  double idle_seconds() const { return idle_; }
  double wakeup_seconds() const { return forgiven_; }  // forgiven so far
  double cpu_seconds() const { return last_.cpu_seconds + waited_; }
  // If it has computed on all processors since then.
  double most_cpu_seconds() const;

 private:
  using Clock = std::chrono::steady_clock;

  void greets();
  bool wait(int descriptor, short events, double window, double most_seconds);

  const CagedProcess& process_;
  Patience patience_;
  CagedProcess::Activity last_ = {};
  bool started_ = false, asked_ = false;
  double all_waited_ = 0;
  double waited_ = 0;     // since the last look
  double woken_ = 0;      // of it: what it takes to wake up, 50 us of each wait that an answer ended
  double forgiven_ = 0;   // the sum of all of these
  double postponed_ = 0;  // of it: the part after which a look has told nothing
  double own_delay_;      // of this thread, at the last look
  double idle_ = 0;
  const char* why_ = nullptr;
};

}  // namespace grader::sandbox

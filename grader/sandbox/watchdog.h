// STAFF ONLY. Waits for a worker, and decides when waiting is useless. Limits inside the cage bound a
// worker's CPU time. The watchdog ends a worker that sleeps, and distinguishes it from one that waits for a
// busy machine.
#pragma once

#include "grader/sandbox/cage.h"

namespace grader {

class Watchdog {
 public:
  // Sums over all waits for one worker.
  struct Patience {
    double idle_seconds = 5;  // neither computing nor waiting for a processor, as observed
    double total_seconds =
        120;  // ends a worker that sleeps in unobservably short naps; about 400 times what all answers take
  };

  Watchdog(const CagedProcess& process, Patience patience) : process_(process), patience_(patience) {}

  // Waits until `descriptor` is ready for `events` (POLLIN, POLLOUT). False: the patience is used up.
  bool wait_for(int descriptor, short events);

  bool waited_in_vain() const { return waited_in_vain_; }

 private:
  const CagedProcess& process_;
  Patience patience_;
  double idle_ = 0, waited_ = 0;
  bool waited_in_vain_ = false;
};

}  // namespace grader

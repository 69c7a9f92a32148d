// STAFF ONLY. Waits for a worker, and says when there is no point in it. A worker's CPU time is limited from
// inside; what the watchdog ends is one that sleeps instead, and it tells that from one which a busy machine
// does not let run.
#pragma once

#include "grader/sandbox/cage.h"

namespace grader {

class Watchdog {
 public:
  // Of all waits for one worker together.
  struct Patience {
    double idle_seconds = 5;  // neither computing nor waiting for a processor, as far as can be seen
    double total_seconds =
        120;  // ends one that dozes in naps too short to be seen; some 400 times what all answers take
  };

  Watchdog(const CagedProcess& process, Patience patience) : process_(process), patience_(patience) {}

  // Waits until `descriptor` is ready for `events` (POLLIN, POLLOUT). False: the patience is at its end.
  bool wait_for(int descriptor, short events);

  bool waited_in_vain() const { return waited_in_vain_; }

 private:
  const CagedProcess& process_;
  Patience patience_;
  double idle_ = 0, waited_ = 0;
  bool waited_in_vain_ = false;
};

}  // namespace grader

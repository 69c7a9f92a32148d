// STAFF ONLY. Waits for a worker, and says when there is no point in it. A worker's CPU time is limited from inside; what the
// watchdog ends is one that sleeps instead, and it tells that from one which a busy machine does not let run.
#pragma once

#include "grader/sandbox/cage.h"

namespace grader {

class Watchdog {
 public:
  struct Patience {
    double asleep_seconds = 5;  // in one wait, so long asleep with an answer due: it will not come
    double total_seconds =
        120;  // of all waits together: ends one that dozes between answers, some 400 times what it takes
  };

  Watchdog(const CagedProcess& process, Patience patience) : process_(process), patience_(patience) {}

  // Waits until `descriptor` is ready for `events` (POLLIN, POLLOUT). False: the patience is at its end.
  bool wait_for(int descriptor, short events);

  bool waited_in_vain() const { return waited_in_vain_; }

 private:
  const CagedProcess& process_;
  Patience patience_;
  double total_waited_ = 0;
  bool waited_in_vain_ = false;
};

}  // namespace grader

// STAFF ONLY. The budget of a submission's code in one exercise, for all its workers together, and the part
// that they have used.
#pragma once

#include <algorithm>

#include "grader/course/budget.h"

namespace grader::inline judge {

struct Allowance {
  Budget limit;
  Budget spent = nothing_spent();

  // A new worker may idle for at most half of the exercise's time, so that one that falls asleep leaves some
  // for the other categories.
  double idle_seconds_of_a_worker() const {
    return std::min(limit.idle_seconds - spent.idle_seconds, limit.idle_seconds / 2);
  }
  double wakeup_seconds = 0;  // is the time that watchdogs have forgiven

  // Starts with the same limit as the idle time.
  double wakeup_seconds_left() const { return std::max(0.0, limit.idle_seconds - wakeup_seconds); }
  double wall_seconds_left() const { return std::max(0.0, limit.wall_seconds - spent.wall_seconds); }
  double cpu_seconds_left() const { return limit.worker_cpu_seconds - spent.worker_cpu_seconds; }
};

}  // namespace grader::judge

// STAFF ONLY. What a submission's code may take in one exercise, all its workers together, and what it has
// taken.
#pragma once

#include <algorithm>

#include "grader/course/budget.h"

namespace grader::inline judge {

struct Allowance {
  Budget limit;
  Budget spent = nothing_spent();

  // What a new worker may take of the idle time: half of the exercise's at most, so that one that falls
  // asleep leaves something for the other categories.
  double idle_seconds_of_a_worker() const {
    return std::min(limit.idle_seconds - spent.idle_seconds, limit.idle_seconds / 2);
  }
  double wakeup_seconds = 0;  // that watchdogs have forgiven

  // As much as there is idle time.
  double wakeup_seconds_left() const { return std::max(0.0, limit.idle_seconds - wakeup_seconds); }
  double wall_seconds_left() const { return std::max(0.0, limit.wall_seconds - spent.wall_seconds); }
  double cpu_seconds_left() const { return limit.worker_cpu_seconds - spent.worker_cpu_seconds; }
};

}  // namespace grader::judge

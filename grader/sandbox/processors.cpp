// STAFF ONLY.
#include "grader/sandbox/processors.h"

#include <algorithm>

namespace grader {

Processors::Processors() {
  CPU_ZERO(&all_);
  if (sched_getaffinity(0, sizeof all_, &all_) != 0) return;
  for (int number = 0; number < CPU_SETSIZE; ++number)
    if (CPU_ISSET(number, &all_)) processors_.push_back({number});
}

Processors::Lease::Lease(Processors& processors) : processors_(processors), holders_(nullptr) {
  if (processors.processors_.empty()) return;
  const std::lock_guard lock(processors.mutex_);
  Processor& chosen = *std::ranges::min_element(processors.processors_, {}, &Processor::holders);
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(chosen.number, &one);
  if (sched_setaffinity(0, sizeof one, &one) == 0) ++*(holders_ = &chosen.holders);
}

Processors::Lease::~Lease() {
  if (holders_ == nullptr) return;
  const std::lock_guard lock(processors_.mutex_);
  --*holders_;
  sched_setaffinity(0, sizeof processors_.all_, &processors_.all_);
}

}  // namespace grader

// STAFF ONLY. Counts the holders of each processor.
#include "grader/sandbox/processes/processors.h"

#include <algorithm>
#include <utility>

namespace grader::inline sandbox {

Processors::Processors() {
  CPU_ZERO(&all_);
  if (sched_getaffinity(0, sizeof all_, &all_) != 0) return;
  for (int number = 0; number < CPU_SETSIZE; ++number)
    if (CPU_ISSET(number, &all_)) processors_.push_back({number});
}

Processors::Lease::Lease(Processors& processors) : processors_(processors), holders_(nullptr) {
  if (processors.processors_.empty()) return;
  const std::lock_guard lock(processors.mutex_);
  // Stays on this processor if no other has fewer holders: the kernel knows the load of other programs.
  const int here = sched_getcpu();
  Processor& chosen = *std::ranges::min_element(processors.processors_, {}, [here](const Processor& one) {
    return std::pair(one.holders, one.number != here);
  });
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(chosen.number, &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) return;
  ++chosen.holders;
  holders_ = &chosen.holders;
}

Processors::Lease::~Lease() {
  if (holders_ == nullptr) return;
  const std::lock_guard lock(processors_.mutex_);
  --*holders_;
  sched_setaffinity(0, sizeof processors_.all_, &processors_.all_);
}

}  // namespace grader::sandbox

// STAFF ONLY. Gives one processor to a pair of programs that talk in turns, as the suite and its worker do.
// One of the pair always waits. On two processors each message wakes a sleeping program; on a virtual machine
// that takes longer than the answer. One processor switches between them faster.
#pragma once

#include <sched.h>

#include <mutex>
#include <vector>

namespace grader::inline sandbox {

class Processors {
 public:
  // Takes those on which the calling thread may run. If the kernel does not report them, no thread is bound.
  Processors();

  // Binds the calling thread, and the programs that it starts, to a processor with the fewest leases, if
  // possible the present one. The lease must end in the same thread, and before `processors`.
  class Lease {
   public:
    explicit Lease(Processors& processors);
    ~Lease();
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

   private:
    Processors& processors_;
    int* holders_;  // counts its processor's leases; null if the thread is not bound
  };

 private:
  struct Processor {
    int number;
    int holders = 0;
  };

  cpu_set_t all_;
  std::vector<Processor> processors_;
  std::mutex mutex_;  // guards the holders
};

}  // namespace grader::sandbox

// STAFF ONLY. Processors for pairs of programs that talk in turns, as a suite does with its worker. One of
// the pair always waits for the other. On two processors each message wakes one that sleeps; on a virtual
// machine that takes longer than the answer. On one processor it is a switch between two programs.
#pragma once

#include <sched.h>

#include <mutex>
#include <vector>

namespace grader::inline sandbox {

class Processors {
 public:
  // Those that the calling thread may run on. If the kernel does not tell, nobody is bound.
  Processors();

  // Binds the calling thread, and the programs that it starts, to the processor that fewest leases hold, the
  // present one among these, as long as it lives. To be destroyed in the same thread, and before
  // `processors`.
  class Lease {
   public:
    explicit Lease(Processors& processors);
    ~Lease();
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

   private:
    Processors& processors_;
    int* holders_;  // of its processor; nothing if the thread is not bound
  };

 private:
  struct Processor {
    int number;
    int holders = 0;  // leases
  };

  cpu_set_t all_;
  std::vector<Processor> processors_;
  std::mutex mutex_;  // guards the holders
};

}  // namespace grader::sandbox

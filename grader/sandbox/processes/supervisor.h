// STAFF ONLY. The process between the grader and a run. It starts the run's first process, counts what all
// processes of the run take, ends them all and waits for each: the grader may be a container's first process,
// or a child of one that waits for nobody. If the grader is gone, it ends the run, too.
#pragma once

#include <sys/types.h>

#include <linux/filter.h>

#include <optional>
#include <vector>

#include "grader/sandbox/processes/descriptor.h"
#include "grader/sandbox/processes/identity.h"

namespace grader::inline sandbox {

// Prepares a new process between fork and exec: the program finds what it needs, and nothing else of ours.
struct Launch {
  // These descriptors belong to the program in its sandbox. bwrap writes about its child to kInfo, and reads
  // a filter from kFilter.
  enum : int { kRequests = 3, kReplies = 4, kInfo = 5, kFilter = 6 };

  std::vector<char*> argv, environment;  // both end with a null
  std::vector<int> joins;                // are open cgroup.procs files
  const char* root = nullptr;            // becomes the root folder; null: no change. Needs root's rights
  const char* folder = nullptr;          // becomes the current folder; null: no change
  int requests = -1, replies = -1, output = -1, info = -1, filter_file = -1;
  Identity identity = {};
  std::vector<sock_filter> filter = {};  // stops system calls; empty: stops none
  bool own_session = false;              // no terminal, and ended first when memory runs out

  // Makes system calls only, since other threads may hold any lock.
  [[noreturn]] void exec() const;
};

// Bounds all processes of a run together; 0: no limit.
struct RunLimits {
  double cpu_seconds = 0;
  std::size_t resident_bytes = 0;
  uid_t user = 0;  // all processes of this user belong to the run; 0: it shares its user with others
};

// Describes how a run ended.
struct RunReport {
  int status = 0;  // is the first process's, as from waitpid
  double cpu_seconds = 0;
  bool over_cpu = false, over_memory = false;
};

class Supervisor {
 public:
  // Throws std::system_error if no process can be started.
  Supervisor(const Launch& launch, const RunLimits& limits);
  ~Supervisor();  // ends the run
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  pid_t process() const { return process_; }           // is the run's first
  const Descriptor& ended() const { return report_; }  // readable once nothing of the run is left
  void end() { control_.close(); }

  RunReport wait();  // returns at its end

 private:
  Descriptor control_, report_;
  pid_t supervisor_ = -1, process_ = -1;
  uid_t user_;
  std::optional<RunReport> told_;
};

}  // namespace grader::sandbox

// STAFF ONLY. A process in a sandbox, from outside: started, watched, waited for and ended.
#pragma once

#include <sys/types.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grader/sandbox/processes/control_groups.h"
#include "grader/sandbox/processes/descriptor.h"
#include "grader/sandbox/sandbox.h"

namespace grader::inline sandbox {

class ContainerRoot;
struct Launch;
struct RunLimits;
class Supervisor;

class SandboxedProcess {
 public:
  using LeaveOut = std::function<void(Launch&, RunLimits&)>;
  // Starts a command, given by its path inside the sandbox. `requests` becomes descriptor 3 and `replies`
  // descriptor 4 (both optional: -1), and `output` descriptors 1 and 2. Tests remove a layer with `leave_out`
  // before the start, to show its purpose. Throws std::system_error if it can't be started.
  SandboxedProcess(const Sandbox& sandbox, const std::vector<std::string>& command, int requests, int replies,
                   int output, const LeaveOut& leave_out = {});
  SandboxedProcess(SandboxedProcess&&) noexcept;
  SandboxedProcess& operator=(SandboxedProcess&&) = delete;
  ~SandboxedProcess();  // kills it

  int handle() const;  // a descriptor, readable once it has ended
  void kill();
  // Waits until it ends or the time is up, then kills it.
  Ending wait(double seconds);

  // The data for a watchdog: what the process has done so far, by the kernel's clocks.
  struct Activity {
    bool alive = false;
    bool started = false;    // its sandbox is ready, and the command runs in it
    double cpu_seconds = 0;  // counts all its threads, also ended ones
    // Holds the times of each of its threads, and of the processes that made its sandbox. Empty if the kernel
    // has no /proc/PID/task/TID/schedstat.
    struct Busy {
      double computed = 0, queued = 0;  // s; the kernel counts a wait only at its end
      bool runnable = false;            // it runs, or waits for a processor
    };
    std::map<pid_t, Busy> busy = {};
  };
  Activity activity() const;

 private:
  pid_t inner_process() const;
  bool has_started(pid_t process) const;

  Isolation isolation_;
  Descriptor info_;  // bwrap writes its child's process id here
  mutable pid_t init_ = -1;
  std::optional<ControlGroup> group_;
  std::optional<long> ended_for_memory_before_;  // set if no group of its own bounds memory
  std::unique_ptr<ContainerRoot> root_;
  std::unique_ptr<Supervisor> run_;
  std::optional<Ending> ending_;
};

// Adds limits to a command inside the sandbox, as the unprivileged user: `prlimit ... -- command`.
std::vector<std::string> with_inner_limits(const Limits& limits, const std::vector<std::string>& command);

}  // namespace grader::sandbox

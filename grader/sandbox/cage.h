// STAFF ONLY. A process in a sandbox: no /proc, no environment, a read-only root with only the mounts, and a
// system call filter. There are two kinds (grader/course/isolation.h). Namespaces: bubblewrap's of users,
// processes, network, mounts, IPC and host names. Container: a user that nobody else has, and a root folder
// that holds links and copies of the mounts.
//
// These layers limit its resources: limits inside the sandbox (`with_inner_limits`, or the worker sets its
// own), a control group if the machine has one, a supervisor that counts the CPU time and memory of all its
// processes, and a watchdog outside that ends the whole sandbox.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/isolation.h"
#include "grader/sandbox/processes/control_group.h"
#include "grader/sandbox/processes/descriptor.h"
#include "grader/sandbox/system_calls/syscalls.h"

namespace grader::inline sandbox {

class ContainerRoot;
struct Launch;
struct RunLimits;
class Warden;

struct Mount {
  std::filesystem::path source;
  std::string target;
  bool writable = false;
};

struct Limits {
  std::size_t memory_bytes = std::size_t{1} << 30;
  // The address space is not bounded: in namespaces the control group alone bounds memory, and without one
  // nothing is started.
  bool memory_of_group = false;
  std::size_t file_bytes = std::size_t{64} << 20;  // bounds each file that it writes
  int processes = 32;                              // counts threads, too
  int cpu_seconds = 20;                            // bounds one process
  double cpu_seconds_of_all = 0;                   // bounds all processes together; 0: no limit
  double wall_seconds = 120;                       // bounds the sandbox
};

struct Cage {
  std::vector<Mount> mounts;
  std::string folder = "/";               // is the current folder inside the sandbox
  std::size_t tmp_bytes = 0;              // is the size of a writable /tmp; 0: no /tmp
  std::optional<Syscalls> syscalls = {};  // is the filter at the start; empty: the process filters itself
  Limits limits = {};
  Isolation isolation = Isolation::namespaces;
  std::filesystem::path roots = {};  // holds root folders, if Isolation is container; belongs to root
};

// Describes how a process ended.
struct Ending {
  int code = 0;                // is its exit code
  int signal = 0;              // is the signal that killed it, or 0
  bool timed_out = false;      // it used up its CPU time, or we killed it
  bool out_of_memory = false;  // the kernel killed it
  double cpu_seconds = 0;      // counts all processes in the sandbox

  bool well() const { return code == 0 && signal == 0 && !timed_out && !out_of_memory; }
};

class CagedProcess {
 public:
  // Starts a command, given by its path inside the sandbox. `requests` becomes descriptor 3 and `replies`
  // descriptor 4 (both optional: -1), and `output` descriptors 1 and 2. Throws std::system_error if it can't
  // be started.
  CagedProcess(const Cage& cage, const std::vector<std::string>& command, int requests, int replies,
               int output);
  // Tests remove a layer with `leave_out` before the start, to show its purpose.
  using LeaveOut = std::function<void(Launch&, RunLimits&)>;
  CagedProcess(const Cage& cage, const std::vector<std::string>& command, int requests, int replies,
               int output, const LeaveOut& leave_out);
  CagedProcess(CagedProcess&&) noexcept;
  CagedProcess& operator=(CagedProcess&&) = delete;
  ~CagedProcess();  // kills it

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
  std::unique_ptr<Warden> run_;
  std::optional<Ending> ending_;
};

// Adds limits to a command inside the sandbox, as the unprivileged user: `prlimit ... -- command`.
std::vector<std::string> with_inner_limits(const Limits& limits, const std::vector<std::string>& command);

}  // namespace grader::sandbox

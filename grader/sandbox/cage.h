// STAFF ONLY. A process in a cage: bubblewrap with its own user, process, network, mount, IPC and host-name
// namespaces, no /proc, no environment, a read-only root with only the mounts, and a system call filter.
//
// Three fences limit its resources: limits inside the cage (`with_inner_limits`, or the worker sets its own),
// a control group if the machine has one, and a watchdog outside that kills the whole cage.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/sandbox/control_group.h"
#include "grader/sandbox/descriptor.h"
#include "grader/sandbox/syscalls.h"

namespace grader {

struct Mount {
  std::filesystem::path source;
  std::string target;
  bool writable = false;
};

struct Limits {
  std::size_t memory_bytes = std::size_t{1} << 30;
  // The control group alone bounds it, and not the address space; without one nothing is started.
  bool memory_of_group = false;
  std::size_t file_bytes = std::size_t{64} << 20;  // of each file that it writes
  int processes = 32;                              // and threads
  int cpu_seconds = 20;                            // of one process
  double wall_seconds = 120;                       // of the cage
};

struct Cage {
  std::vector<Mount> mounts;
  std::string folder = "/";               // the current folder inside the cage
  std::size_t tmp_bytes = 0;              // the size of a writable /tmp; 0: none
  std::optional<Syscalls> syscalls = {};  // the filter at the start; none: the process puts itself under one
  Limits limits = {};
  // The command is the first process of its name space and takes leave of its children itself, as compilers do.
  // Then it is known how much CPU time all of them took.
  bool as_first_process = false;
  // False: no cage at all, for machines that can't make one and for --unsafe-no-sandbox. Paths inside are
  // then replaced by those outside.
  bool isolated = true;
};

// How a process ended.
struct Ending {
  int code = 0;                // its exit code
  int signal = 0;              // or the signal that killed it
  bool timed_out = false;      // it used up its CPU time, or we killed it
  bool out_of_memory = false;  // the kernel killed it
  double cpu_seconds = 0;      // of all its processes, if it was the first one and has ended by itself

  bool well() const { return code == 0 && signal == 0 && !timed_out && !out_of_memory; }
};

class CagedProcess {
 public:
  // Starts a command, given by its path inside the cage. `requests` becomes descriptor 3 and `replies`
  // descriptor 4 (both optional: -1), and `output` descriptors 1 and 2. Throws std::system_error if it can't
  // be started.
  CagedProcess(const Cage& cage, const std::vector<std::string>& command, int requests, int replies,
               int output);
  CagedProcess(CagedProcess&& other) noexcept;
  CagedProcess& operator=(CagedProcess&&) = delete;
  ~CagedProcess();  // kills it

  Descriptor handle() const;  // readable once it has ended
  void kill();
  // Waits until it ends or the time is up, then kills it.
  Ending wait(double seconds);

  // The data for a watchdog: what the process has done so far, by the kernel's clocks.
  struct Activity {
    bool alive = false;
    bool started = false;    // its cage is made, and the command runs in it
    double cpu_seconds = 0;  // of all its threads, also those that have ended
    // What each of its threads has computed and waited for a processor; and those of the processes that made its
    // cage. Empty if the kernel does not tell (it has no /proc/PID/task/TID/schedstat).
    struct Busy {
      double computed = 0, queued = 0;  // s; the kernel counts a wait when it is over
      bool runnable = false;            // it runs, or waits for a processor
    };
    std::map<pid_t, Busy> busy = {};
  };
  Activity activity() const;

 private:
  pid_t inner_process() const;

  pid_t process_ = -1;
  bool isolated_;
  Descriptor info_;  // bwrap writes its child's process id here
  mutable pid_t init_ = -1;
  std::optional<ControlGroup> group_;
  std::optional<Ending> ending_;
};

// Adds limits to a command inside the cage, as the unprivileged user: `prlimit ... -- command`.
std::vector<std::string> with_inner_limits(const Limits& limits, const std::vector<std::string>& command);

// Mounts for this program's own C++ library and libseccomp: all that a worker needs from the system.
std::vector<Mount> runtime_library_mounts();

// Mounts for the folders of the system's libraries.
std::vector<Mount> library_mounts();

// Mounts for the system's compiler and linker, without any headers.
std::vector<Mount> toolchain_mounts();

// Mounts for the headers of the C and C++ libraries, and for the headers in `folders` of /usr/include; no
// other installed headers.
std::vector<Mount> header_mounts(const std::filesystem::path& empty_folder,
                                 const std::vector<std::string>& folders = {});

}  // namespace grader

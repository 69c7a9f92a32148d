// STAFF ONLY. A process in a cage: bubblewrap with a user, process, network, mount, IPC and host-name space
// of its own, no /proc, no environment, a read-only root that holds nothing but what is mounted, and a system
// call filter.
//
// Three fences limit what it uses: limits that the process gets inside (`inner_limits`, or the worker sets
// its own), a control group where the machine has one, and a watchdog out here that kills the cage as a
// whole.
#pragma once

#include <sys/types.h>

#include <filesystem>
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
  std::size_t file_bytes = std::size_t{64} << 20;  // of one file that it writes
  int processes = 32;                              // and threads
  int cpu_seconds = 20;                            // of one process
  double wall_seconds = 120;                       // of the cage
};

struct Cage {
  std::vector<Mount> mounts;
  std::string folder = "/";   // the current one, inside
  std::size_t tmp_bytes = 0;  // the size of a writable /tmp; 0: none
  std::optional<Syscalls> syscalls =
      {};  // the filter to start under; none: the process puts itself under one
  Limits limits = {};
  // False: no cage at all, for machines that have none and --unsafe-no-sandbox. Paths inside are then
  // replaced by those outside.
  bool isolated = true;
};

// How a process ended.
struct Ending {
  int code = 0;                // what it returned
  int signal = 0;              // or what killed it
  bool timed_out = false;      // it used up its CPU time, or the watchdog ended it
  bool out_of_memory = false;  // the kernel ended it

  bool well() const { return code == 0 && signal == 0 && !timed_out && !out_of_memory; }
};

class CagedProcess {
 public:
  // Starts a command, given by its path inside. It finds `requests` as descriptor 3 and `replies` as 4 (both
  // optional: -1), and `output` as 1 and 2. Throws std::system_error if it can't be started.
  CagedProcess(const Cage& cage, const std::vector<std::string>& command, int requests, int replies,
               int output);
  CagedProcess(CagedProcess&& other) noexcept;
  CagedProcess& operator=(CagedProcess&&) = delete;
  ~CagedProcess();  // kills it

  void kill();
  // Waits until it ends by itself or the time is up, then kills it.
  Ending wait(double seconds);

  // What a watchdog looks at. A process that a busy machine does not let run, or that waits for the disk,
  // wants to run; one that sleeps, is stopped or has left its threads alone does not.
  struct Activity {
    bool wants_to_run = false;
    double cpu_seconds = 0;
  };
  Activity activity() const;

 private:
  pid_t inner_process() const;

  pid_t process_ = -1;
  bool isolated_;
  Descriptor info_;  // where bwrap says who its child is
  mutable pid_t init_ = -1;
  std::optional<ControlGroup> group_;
  std::optional<Ending> ending_;
};

// Puts limits on a command, inside of the cage, as the unprivileged user: `prlimit ... -- command`.
std::vector<std::string> with_inner_limits(const Limits& limits, const std::vector<std::string>& command);

// Mounts for the C++ library and libseccomp that this program itself runs with: all that a worker needs of
// the system.
std::vector<Mount> runtime_library_mounts();

// Mounts for the system's compiler and linker, without any headers.
std::vector<Mount> toolchain_mounts();

// Mounts for the headers of the C and C++ libraries; of others that are installed, none but those in
// `folders` of /usr/include.
std::vector<Mount> header_mounts(const std::filesystem::path& empty_folder,
                                 const std::vector<std::string>& folders = {});

}  // namespace grader

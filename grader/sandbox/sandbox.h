// STAFF ONLY. A process in a sandbox: no /proc, no environment, a read-only root with only the mounts, and a
// system call filter. There are two kinds (grader/course/isolation.h). Namespaces: bubblewrap's of users,
// processes, network, mounts, IPC and host names. Container: a user that nobody else has, and a root folder
// that holds links and copies of the mounts.
//
// These layers limit its resources: limits inside the sandbox (`with_inner_limits`, or the worker sets its
// own), a control group if the machine has one, a supervisor that counts the CPU time and memory of all its
// processes, and a watchdog outside that ends the whole sandbox.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/isolation.h"
#include "grader/sandbox/system_calls/syscalls.h"

namespace grader::inline sandbox {

struct Mount {
  std::filesystem::path source;
  std::string target;
  bool writable = false;
};

struct Limits {
  std::size_t memory_bytes = std::size_t{1} << 30;
  std::size_t file_bytes = std::size_t{64} << 20;  // bounds each file that it writes
  int processes = 32;                              // counts threads, too
  int cpu_seconds = 20;                            // bounds one process
  double cpu_seconds_of_all = 0;                   // bounds all processes together; 0: no limit
  double wall_seconds = 120;                       // bounds the sandbox
};

struct Sandbox {
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

}  // namespace grader::sandbox

// STAFF ONLY. The system calls that a sandboxed process may use. All others fail with EPERM; clone3 fails
// with ENOSYS, so that the C library falls back to clone, whose flags a filter can inspect.
#pragma once

#include <linux/filter.h>

#include <vector>

namespace grader::inline sandbox {

enum class Syscalls {
  // Compute, allocate, print, start threads, read existing files. No processes, no sockets, no writing to
  // files. System calls that honest student code never needs (see `denied_syscall`) raise SIGSYS, so that the
  // worker can report them.
  compute,
  // The same for a process that handles SIGSYS. Nothing blocks that signal: calls that
  // block signals raise it, too. So do exit codes above 127, which look like an end by a signal.
  worker,
  // Also has what a compiler and a linker need: processes and files.
  toolchain,
};

// Puts this process and all its later children under the filter permanently. Throws std::runtime_error.
void restrict_syscalls(Syscalls kept);

// Returns the filter program on a descriptor, for bwrap's --seccomp (close-on-exec; the caller closes it).
int syscall_filter_descriptor(Syscalls kept);

// Returns the filter as instructions for the system call `seccomp`.
std::vector<sock_filter> syscall_filter(Syscalls kept);

// Returns a phrase for the intention of a system call, as in "to open a network connection".
const char* denied_syscall(int number);

// Handles SIGSYS, to report the system calls that Syscalls::worker stops.
//
// A signal that is blocked when the filter raises it ends the process at once, and the attempt stays unknown:
// the C library blocks all signals before it starts another process (system, popen, posix_spawn). So the
// filter also stops calls that block signals; this handler does their work, but never blocks SIGSYS.
//
// Both may be called at any point of the process's code. After `denied` the call fails with EPERM. `leaves`
// comes before an exit code above 127; if it returns, the process ends with 1.
void hear_of_stopped_calls(void (*denied)(int number), void (*leaves)(int code));

}  // namespace grader::sandbox

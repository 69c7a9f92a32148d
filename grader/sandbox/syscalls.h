// STAFF ONLY. The system calls that a caged process keeps. Everything else fails with EPERM; clone3 fails
// with ENOSYS, so that the C library falls back to clone, whose flags a filter can see.
#pragma once

namespace grader {

enum class Syscalls {
  // Compute, allocate, print, start threads, read files that are there. No processes, no sockets, no writing
  // to files. What student code has no honest use for (see `denied_syscall`) raises SIGSYS, so that the
  // worker can say so.
  compute,
  // What a compiler and a linker need beside: processes and files.
  toolchain,
};

// Puts this process and all that it will start under the filter, for good. Throws std::runtime_error.
void restrict_syscalls(Syscalls kept);

// The filter as a program that bwrap's --seccomp reads from a descriptor (close-on-exec; the caller closes
// it).
int syscall_filter_descriptor(Syscalls kept);

// For people: what the system call with that number was trying to do, as in "to open a network connection".
const char* denied_syscall(int number);

}  // namespace grader

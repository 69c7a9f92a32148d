// STAFF ONLY. How a process under Syscalls::worker hears of the system calls that its filter stops.
//
// A signal that is blocked when the filter raises it ends the process at once, and nobody knows what it
// tried: the C library blocks all signals before it starts another process (system, popen, posix_spawn). So
// the filter stops calls that block signals, too, and what is here does their work, but for SIGSYS.
#pragma once

namespace grader::inline sandbox {

// Both may be called at any point of the process's code. `denied`: a system call, which then fails with
// EPERM. `leaves`: the process ends, with an exit code above 127; if this returns, it ends with 1.
void hear_of_stopped_calls(void (*denied)(int number), void (*leaves)(int code));

}  // namespace grader::sandbox

// STAFF ONLY. Reports the system calls that the filter Syscalls::worker stops.
//
// A signal that is blocked when the filter raises it ends the process at once, and the attempt stays unknown:
// the C library blocks all signals before it starts another process (system, popen, posix_spawn). So the
// filter also stops calls that block signals; this handler does their work, but never blocks SIGSYS.
#pragma once

namespace grader::inline sandbox {

// Both may be called at any point of the process's code. After `denied` the call fails with EPERM. `leaves`
// comes before an exit code above 127; if it returns, the process ends with 1.
void hear_of_stopped_calls(void (*denied)(int number), void (*leaves)(int code));

}  // namespace grader::sandbox

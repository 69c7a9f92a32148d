// STAFF ONLY. Sets what a process inherits, as far as it could change a verdict: limits, the environment,
// signals, the mask for new files, the three standard descriptors, the personality. The grader sets all of
// it, and what it starts inherits that.
//
//   soft limits            as high as needed; the stack's is 8 MiB, as at home; no core files
//   the environment        HOME, XDG_..., TMPDIR if sandboxes can use it, options of sanitizers; nothing else
//   signals                none is ignored or blocked, but SIGHUP if it was ignored (nohup)
//   the mask (umask)       takes nothing from the owner; what a sandbox reads gets its mode by name
//   standard descriptors   /dev/null where one is closed
//   the personality        Linux's own: random addresses, no compatible layouts
#pragma once

namespace grader::inline sandbox {

// Runs first in main. Some settings act only when a program starts: for these it starts this program once
// more, with the same arguments. If it may not, it ends the process with a line and exit code 1.
void set_what_is_inherited(char* argv[]);

// Lists what hard limits must leave. Only root may raise hard limits.
struct Needs {
  int jobs = 1;            // submissions that are graded at a time
  double cpu_seconds = 0;  // the longest that one process needs
};

// Throws std::runtime_error with both numbers in one line if a hard limit is below the need.
void require_hard_limits(const Needs& needs);

// True if the starter of this process wants a signal ignored.
bool is_ignored(int signal);

}  // namespace grader::sandbox

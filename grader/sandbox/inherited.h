// STAFF ONLY. What a process inherits from whoever starts it, as far as it could change a verdict: limits,
// the environment, signals, the mask for new files, the three standard descriptors, the personality. The
// grader sets all of it, and what it starts inherits that.
//
//   soft limits            as high as is ever needed; the stack's is 8 MiB, as at home; no core files
//   the environment        HOME, XDG_..., TMPDIR if sandboxes can use it, options of sanitizers; nothing else
//   signals                none is ignored or blocked, but SIGHUP if it was ignored (nohup)
//   the mask (umask)       takes nothing from the owner; what a sandbox reads gets its mode by name
//   standard descriptors   /dev/null where one is closed
//   the personality        Linux's own: random addresses, no compatible layouts
#pragma once

namespace grader::inline sandbox {

// The first thing in main. Some of this acts only when a program starts: then it starts this program once
// more, with the same arguments. Without the right to do so it ends the process with a line and exit code 1.
void set_what_is_inherited(char* argv[]);

// Hard limits must leave this much. Only root may raise them.
struct Needs {
  bool sanitizers = true;  // their runtime reserves addresses for a shadow of all memory
  int jobs = 1;            // submissions at a time
  double cpu_seconds = 0;  // of the process that takes most
};

// Throws std::runtime_error, in a line with both numbers, if a hard limit is below what is needed.
void require_hard_limits(const Needs& needs);

// True if whoever started us wants a signal ignored.
bool is_ignored(int signal);

}  // namespace grader::sandbox

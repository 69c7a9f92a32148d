// STAFF ONLY. Finds the kinds of isolation that tests can use: most containers allow no namespaces.
#pragma once

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "grader/course/isolation.h"
#include "grader/sandbox/processes/identity.h"

namespace grader::inline sandbox {

// Returns the sentence with which a test of this kind skips, or an empty one. It asks the kernel, not the
// grader: a broken grader skips no test.
inline std::string why_not(Isolation kind) {
  static const bool makes_namespaces = [] {
    const pid_t child = fork();
    if (child == 0) _exit(become(sandbox_identity()) && unshare(CLONE_NEWUSER | CLONE_NEWNET) == 0 ? 0 : 1);
    int status = 1;
    waitpid(child, &status, 0);
    return status == 0;
  }();
  if (kind == Isolation::namespaces && !makes_namespaces)
    return "the kernel makes no namespaces here, as in most containers";
  if (kind == Isolation::container && geteuid() != 0) return "only root gives each run a user of its own";
  return "";
}

// Returns namespaces where they can be made. For tests that are not about isolation.
inline Isolation isolation_for_tests() {
  return why_not(Isolation::namespaces).empty() ? Isolation::namespaces : Isolation::container;
}

}  // namespace grader::sandbox

// STAFF ONLY. Tests the layers of each kind of sandbox.
#include "grader/grading/isolation_here.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <string>

#include "grader/course/input.h"
#include "grader/sandbox/fences.h"
#include "grader/sandbox/system_mounts.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

// Threads start by this call, and by another one only if the kernel does not know this one.
void require_threads() {
  if (syscall(SYS_clone3, nullptr, 0) == -1 && errno == EPERM)
    throw BadInput(
        "this machine forbids the system call clone3 with EPERM, as Docker before 20.10.10 does, so that "
        "programs can't start threads; update Docker, or start the container with --security-opt "
        "seccomp=unconfined");
}

// Returns why its layers do not hold, or an empty text.
std::string why_not(Isolation kind, const StagedKit& kit) {
  if (kind == Isolation::namespaces && !fs::exists("/usr/bin/bwrap"))
    return "bubblewrap is not installed; install the package bubblewrap";
  if (kind == Isolation::container && geteuid() != 0)
    return "it needs root, who gives each run a user of its own";
  Sandbox sandbox;
  sandbox.isolation = kind;
  sandbox.roots = kit.roots();
  sandbox.mounts = runtime_library_mounts();
  sandbox.mounts.push_back({kit.folder() / "probe", "/probe"});
  try {
    return open_fence(sandbox);
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::string ending_with_full_stop(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  return text;
}

}  // namespace

Isolation isolation_here(const StagedKit& kit, std::optional<Isolation> asked) {
  require_threads();
  if (asked == Isolation::none) return *asked;
  std::string reasons;
  for (const Isolation kind : {Isolation::namespaces, Isolation::container}) {
    if (asked && *asked != kind) continue;
    const std::string why = why_not(kind, kit);
    if (why.empty()) return kind;
    reasons +=
        (reasons.empty() ? "" : "; ") + std::string(to_string(kind)) + ": " + ending_with_full_stop(why);
  }
  throw BadInput(
      "this machine can't isolate student code (" + reasons +
      "). Namespaces need bubblewrap 0.8 or later and unprivileged user namespaces (sysctl "
      "kernel.unprivileged_userns_clone=1, user.max_user_namespaces > 0; on Ubuntu "
      "kernel.apparmor_restrict_unprivileged_userns=0); a container needs root. --unsafe-no-sandbox runs "
      "student code all the same, and stamps the report");
}

}  // namespace grader::grading

// STAFF ONLY.
#include "grader/tool/isolation.h"

#include <filesystem>

#include "grader/sandbox/cage.h"

namespace grader {

std::string why_not_isolated(const StagedKit& kit) {
  if (!std::filesystem::exists("/usr/bin/bwrap"))
    return "bubblewrap is not installed; install the package bubblewrap";
  Cage cage;
  cage.mounts = runtime_library_mounts();
  cage.mounts.push_back({kit.folder() / "worker", "/worker"});
  Pipe output = make_pipe();
  CagedProcess process(cage, {"/worker"}, -1, -1, output.write_end.get());
  output.write_end.close();
  const std::string text = read_all(output.read_end, 1000, 10);
  const Ending ending = process.wait(10);
  constexpr int kWorkerWithoutArguments = 2;
  if (ending.code == kWorkerWithoutArguments) return {};
  return "a caged program does not start: " + (text.empty() ? "no reason given\n" : text) +
         "It needs bubblewrap 0.8 or later and unprivileged user namespaces (sysctl "
         "kernel.unprivileged_userns_clone=1, "
         "user.max_user_namespaces > 0; on Ubuntu kernel.apparmor_restrict_unprivileged_userns=0)";
}

}  // namespace grader

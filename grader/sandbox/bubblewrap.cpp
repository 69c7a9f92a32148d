// STAFF ONLY. Writes bubblewrap's command.
#include "grader/sandbox/bubblewrap.h"

#include <system_error>

#include "grader/sandbox/processes/launch.h"

namespace grader::inline sandbox {

std::vector<std::string> bubblewrap_command(const Sandbox& sandbox, const std::vector<std::string>& command,
                                            bool filtered) {
  std::vector<std::string> all = {"/usr/bin/bwrap",
                                  "--unshare-user",
                                  "--unshare-pid",
                                  "--unshare-net",
                                  "--unshare-ipc",
                                  "--unshare-uts",
                                  "--unshare-cgroup-try",
                                  "--disable-userns",
                                  "--die-with-parent",
                                  "--new-session",
                                  "--clearenv",
                                  "--hostname",
                                  "sandbox",
                                  "--info-fd",
                                  std::to_string(Launch::kInfo)};
  auto append = [&all](std::initializer_list<std::string> words) { all.insert(all.end(), words); };
  if (filtered) append({"--seccomp", std::to_string(Launch::kFilter)});
  if (sandbox.tmp_bytes > 0)
    append({"--size", std::to_string(sandbox.tmp_bytes), "--tmpfs", "/tmp", "--dev-bind", "/dev/null",
            "/dev/null"});
  for (const Mount& mount : sandbox.mounts) {
    std::error_code error;
    if (std::filesystem::is_symlink(mount.source, error) && mount.source == mount.target)
      append({"--symlink", std::filesystem::read_symlink(mount.source).string(), mount.target});
    else
      append({mount.writable ? "--bind" : "--ro-bind", mount.source.string(), mount.target});
  }
  // A compilation gives the same bytes at any time: __DATE__ and __TIME__ are fixed.
  append({"--setenv", "PATH", "/usr/bin", "--setenv", "LC_ALL", "C", "--setenv", "SOURCE_DATE_EPOCH", "1"});
  append({"--remount-ro", "/", "--chdir", sandbox.folder, "--"});
  all.insert(all.end(), command.begin(), command.end());
  return all;
}

}  // namespace grader::sandbox

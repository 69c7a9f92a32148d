// STAFF ONLY.
#include "grader/sandbox/identity.h"

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace grader {

Identity sandbox_identity() {
  if (geteuid() != 0) return {geteuid(), getegid(), false};
  return {kSandboxUser, kSandboxUser, true};
}

bool become(const Identity& identity) {
  if (!identity.changes) return true;
  return setgroups(0, nullptr) == 0 && setresgid(identity.group, identity.group, identity.group) == 0 &&
         setresuid(identity.user, identity.user, identity.user) == 0;
}

void share_with_sandbox(const std::filesystem::path& folder, bool writable) {
  const Identity identity = sandbox_identity();
  if (identity.changes && chown(folder.c_str(), writable ? identity.user : 0, identity.group) != 0)
    throw std::system_error(errno, std::generic_category(), "chown " + folder.string());
  if (chmod(folder.c_str(), 0750) != 0)
    throw std::system_error(errno, std::generic_category(), "chmod " + folder.string());
}

}  // namespace grader

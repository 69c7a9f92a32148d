// STAFF ONLY.
#include "grader/sandbox/identity.h"

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "hair/io/files/bad_input.h"

namespace grader {

namespace {

// True if the list /proc/self/uid_map or gid_map has the sandbox's user or group: lines of "first, first outside, count".
bool has_sandbox_user(const char* map) {
  std::ifstream in(map);
  if (!in) return true;  // no namespaces
  for (unsigned long first = 0, outside = 0, count = 0; in >> first >> outside >> count;)
    if (kSandboxUser >= first && kSandboxUser - first < count) return true;
  return false;
}

}  // namespace

Identity sandbox_identity() {
  if (geteuid() != 0) return {geteuid(), getegid(), false};
  if (!has_sandbox_user("/proc/self/uid_map") || !has_sandbox_user("/proc/self/gid_map"))
    throw hair::BadInput(
        "this root belongs to a user namespace without the user and group " + std::to_string(kSandboxUser) +
        ", who run student code (unshare -Ur makes such a root); run hairgrade as an ordinary user, or as "
        "root of the machine");
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
    throw hair::BadInput(
        folder.string() + ": can't be given to the user " + std::to_string(identity.user) +
        ", who runs student code (" + std::generic_category().message(errno) +
        "); give root the right to change owners (CAP_CHOWN), or run hairgrade as an ordinary user");
  if (chmod(folder.c_str(), 0750) != 0)
    throw std::system_error(errno, std::generic_category(), "chmod " + folder.string());
}

}  // namespace grader

// STAFF ONLY. The user that runs a sandbox. A sandbox started by root could write host kernel settings
// through /proc, so root first becomes a separate unprivileged user.
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace grader::inline sandbox {

struct Identity {
  uid_t user = 0;
  gid_t group = 0;
  bool changes = false;  // true: we are root and drop root
};

// Root becomes this user and group, which no account should have; other users stay themselves.
inline constexpr uid_t kSandboxUser = 64123;

// Throws BadInput for root of a user namespace that has no such user, as `unshare -Ur` makes it: it can drop
// no rights.
Identity sandbox_identity();

// For root, where nothing else keeps runs apart: a user and a group, drawn anew for each run. They are high
// numbers, for the kernel counts a user's processes in all containers of a host together. Throws BadInput
// where there are none.
Identity identity_of_a_run();

// Drops root permanently. Async-signal-safe, for use between fork and exec. False if the kernel refuses.
bool become(const Identity& identity);

// Makes a folder readable only for the sandbox user and us; `writable`: also writable.
void share_with_sandbox(const std::filesystem::path& folder, bool writable);

}  // namespace grader::sandbox

// STAFF ONLY. Who the cage runs as. A cage that root starts could write host kernel settings through /proc,
// so root first becomes an unprivileged user of its own.
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace grader {

struct Identity {
  uid_t user = 0;
  gid_t group = 0;
  bool changes = false;  // true: we are root and give it up
};

// Root becomes this user and group, which no account should have; anybody else stays.
inline constexpr uid_t kSandboxUser = 64123;

Identity sandbox_identity();

// Gives up root for good. Async-signal-safe: for use between fork and exec. False if the kernel refuses.
bool become(const Identity& identity);

// A folder that the sandbox user can read and nobody else but us; `writable`: can write, too.
void share_with_sandbox(const std::filesystem::path& folder, bool writable);

}  // namespace grader

// STAFF ONLY. The user that runs a sandbox, and a folder for it. A sandbox of root could write the host's
// kernel settings through /proc, so root first becomes a separate unprivileged user.
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline sandbox {

struct Identity {
  uid_t user = 0;
  gid_t group = 0;
  bool changes = false;  // true: we are root and drop root
};

// Root becomes this user and group, which no account should have; other users stay themselves.
inline constexpr uid_t kSandboxUser = 64123;

// Throws BadInput for root of a user namespace without this user, as `unshare -Ur` makes it: it can't drop
// its rights.
Identity sandbox_identity();

// For root, where only the user keeps runs apart: draws a new user and group for each run. Their numbers are
// high, since the kernel counts a user's processes in all containers of a host together. Throws BadInput if
// this namespace has no such numbers.
Identity identity_of_a_run();

// Drops root permanently. Async-signal-safe, for use between fork and exec. False if the kernel refuses.
bool become(const Identity& identity);

// Makes a folder readable for the sandbox user and us alone; `writable`: also writable.
void share_with_sandbox(const std::filesystem::path& folder, bool writable);

// A new folder in the system's temporary folder, which only we and the sandbox's user can read. Its
// destructor removes it; after a SIGKILL the next such object does.
class StagingFolder {
 public:
  StagingFolder();  // throws BadInput if none can be made
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Descriptor lock_;  // held while the folder is in use
};

}  // namespace grader::sandbox

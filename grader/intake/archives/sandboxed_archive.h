// STAFF ONLY. Reads archives in a sandbox: libarchive meets hostile bytes in a process that holds only the
// system's libraries, without rights, network or names of files. Each archive, also a nested one, has a
// process of its own, so that an archive that breaks its reader costs itself alone.
//
// The trusted side opens the file and passes the descriptor. So the process needs no right to the
// instructor's folders, and no path leads out of it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "grader/intake/archives/archive.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/sandbox.h"

namespace grader::inline intake {

class SandboxedReader {
 public:
  // `program` is hairintake. It is copied to a folder that the sandbox's user can read. A process with a
  // SandboxedReader must ignore SIGPIPE: a reader may end at any time.
  explicit SandboxedReader(const std::filesystem::path& program, Isolation isolation = Isolation::namespaces);

  // It throws Unreadable for a file that can't be opened, and std::runtime_error if no reader starts at all.
  // A container must not outlive this object, and may be visited once. Its list and visit throw Unreadable if
  // a reader breaks down, takes too much time or memory, or deviates from the protocol.
  OpenArchive opener() const;

 private:
  StagingFolder folder_;
  Sandbox sandbox_;
};

}  // namespace grader::intake

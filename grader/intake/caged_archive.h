// STAFF ONLY. Archives, read in a sandbox: libarchive meets hostile bytes in a process that holds nothing but
// the system's libraries, without rights, network or names of files. Each archive, also each one in another,
// has a process of its own, so that one that breaks its reader costs itself alone.
//
// The trusted side opens the file and hands over the descriptor. So the process needs no right to the
// instructor's folders, and no path leads out of it to anything else.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "grader/intake/archive.h"
#include "grader/sandbox/cage.h"
#include "grader/sandbox/staging_folder.h"

namespace grader::inline intake {

class CagedReader {
 public:
  // `program`: hairintake. It is copied to where the sandbox's user can read it. The process that uses this
  // must ignore SIGPIPE: a reader may end at any time.
  explicit CagedReader(const std::filesystem::path& program, Isolation isolation = Isolation::namespaces);

  // Throws Unreadable for a file that can't be opened, and std::runtime_error if no reader starts at all.
  // What it returns must not outlive this, and may be visited once. A reader that breaks down, takes too much
  // time or memory, or says what no reader says, makes list and visit throw Unreadable.
  std::unique_ptr<Container> open(const ArchiveSource& source, const std::string& shown,
                                  ArchiveLimits limits) const;

  OpenArchive opener() const;

 private:
  StagingFolder folder_;
  Cage cage_;
};

// The sandbox of a reader, whose program is the file `program`.
Cage reader_cage(const std::filesystem::path& program, Isolation isolation);

}  // namespace grader::intake

// STAFF ONLY. A new folder in the system's temporary folder, which only we and the sandbox's user can read.
// Its destructor removes it; after a SIGKILL the next such object does.
#pragma once

#include <filesystem>

#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline sandbox {

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

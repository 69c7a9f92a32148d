// STAFF ONLY. A new folder in the system's folder for temporary files, which only we and the sandbox's user
// can read. It goes with its object, or, after a SIGKILL, when the next one is made.
#pragma once

#include <filesystem>

#include "grader/sandbox/descriptor.h"

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

// STAFF ONLY. The grading kit (see grader/worker/CMakeLists.txt), copied to where the sandbox's user can read
// it and nobody else: a clone under /root can't be mounted from there.
#pragma once

#include <filesystem>
#include <string>

#include "grader/course/course.h"
#include "grader/sandbox/descriptor.h"

namespace grader {

class StagedKit {
 public:
  // A new folder in the system's folder for temporary files. Throws BadInput if the kit is not there or not
  // complete.
  StagedKit(const std::filesystem::path& kit, const Course& course);
  StagedKit(const StagedKit&) = delete;
  StagedKit& operator=(const StagedKit&) = delete;
  ~StagedKit();  // removes the folder

  std::filesystem::path folder() const { return root_ / "kit"; }
  std::filesystem::path empty_folder() const { return root_ / "empty"; }

  // A new folder beside it for one job, which the sandbox's user can read.
  std::filesystem::path new_job(const std::string& name) const;

  // Changes whenever what student code is compiled against, or run by, does.
  const std::string& hash() const { return hash_; }

 private:
  std::filesystem::path root_;
  Descriptor lock_;  // held as long as the folder is in use
  std::string hash_;
};

}  // namespace grader

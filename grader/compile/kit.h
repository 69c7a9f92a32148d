// STAFF ONLY. A copy of the grading kit (see grader/worker/CMakeLists.txt) in a place that only the sandbox's
// user can read. The original can't be mounted directly if the clone is under /root.
#pragma once

#include <filesystem>
#include <string>

#include "grader/course/course.h"
#include "grader/sandbox/descriptor.h"

namespace grader {

class StagedKit {
 public:
  // Makes a new folder in the system's folder for temporary files. Throws BadInput if the kit is missing or
  // incomplete.
  StagedKit(const std::filesystem::path& kit, const Course& course);
  StagedKit(const StagedKit&) = delete;
  StagedKit& operator=(const StagedKit&) = delete;
  ~StagedKit();  // removes the folder

  std::filesystem::path folder() const { return root_ / "kit"; }
  std::filesystem::path empty_folder() const { return root_ / "empty"; }

  // A new folder beside it for one job; the sandbox's user can read it.
  std::filesystem::path new_job(const std::string& name) const;

  // Changes whenever the files change that student code is compiled against or run by.
  const std::string& hash() const { return hash_; }

 private:
  std::filesystem::path root_;
  Descriptor lock_;  // held while the folder is in use
  std::string hash_;
};

}  // namespace grader

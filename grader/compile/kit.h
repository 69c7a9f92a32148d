// STAFF ONLY. A copy of the grading kit (see grader/worker/CMakeLists.txt) in a folder that only the
// sandbox's user can read. The original can't be mounted directly if the clone is under /root.
#pragma once

#include <filesystem>
#include <string>

#include "grader/course/course.h"
#include "grader/sandbox/processes/staging_folder.h"

namespace grader::inline compile {

class StagedKit {
 public:
  // Throws BadInput if the kit is missing or incomplete.
  StagedKit(const std::filesystem::path& kit, const Course& course);
  StagedKit(const StagedKit&) = delete;
  StagedKit& operator=(const StagedKit&) = delete;

  std::filesystem::path folder() const { return root_.path() / "kit"; }
  std::filesystem::path empty_folder() const { return root_.path() / "empty"; }
  std::filesystem::path roots() const {
    return root_.path() / "roots";
  }  // see grader/sandbox/container_root.h

  // Makes a new folder beside it for one job; the sandbox's user can read it.
  std::filesystem::path new_job(const std::string& name) const;

  // Changes with every file that student code is compiled against or run by.
  const std::string& hash() const { return hash_; }

 private:
  StagingFolder root_;
  std::string hash_;
};

}  // namespace grader::compile

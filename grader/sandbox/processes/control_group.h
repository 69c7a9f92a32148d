// STAFF ONLY. Limits on memory and processes for a whole sandbox, if the kernel's control groups (v1 or v2)
// are writable. Otherwise only the limits inside the sandbox apply.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace grader::inline sandbox {

class ControlGroup {
 public:
  // Returns nothing if no control group can be made here.
  static std::optional<ControlGroup> create(std::size_t memory_bytes, int processes);

  ControlGroup(ControlGroup&&) noexcept = default;
  ControlGroup& operator=(ControlGroup&&) = delete;
  ~ControlGroup();  // kills the remaining processes in it

  // Returns false if it bounds the number of processes alone.
  bool bounds_memory() const { return bounds_memory_; }

  // Returns the files to which a process writes "0" to join.
  std::vector<std::filesystem::path> join_files() const;
  bool ran_out_of_memory() const;

 private:
  ControlGroup(std::vector<std::filesystem::path> folders, bool bounds_memory)
      : folders_(std::move(folders)), bounds_memory_(bounds_memory) {}

  std::vector<std::filesystem::path> folders_;  // one (v2), or one for memory and one for pids (v1)
  bool bounds_memory_;
};

}  // namespace grader::sandbox

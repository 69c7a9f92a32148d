// STAFF ONLY. The kernel's control groups (v1 or v2): those that we make, and our own ones, with this
// process's share of the machine. A container's programs count all processors and all memory of the host if
// they ask the machine.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grader::inline sandbox {

// Limits memory and processes of a whole sandbox, if control groups are writable. Otherwise only the limits
// inside the sandbox apply.
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

// Lists folders of the groups with this controller ("": those of v2): our own, then those above it, up to the
// mounted one. Empty if there are no groups. `root` holds /proc and the mounted folders.
std::vector<std::filesystem::path> own_groups(const std::string& controller,
                                              const std::filesystem::path& root = "/");

double usable_processors(const std::filesystem::path& root = "/");         // counts parts of a processor, too
std::size_t usable_memory_bytes(const std::filesystem::path& root = "/");  // is the machine's memory, or less

// Counts the submissions to grade at a time: one a processor, if each has memory for a compiler.
int usable_jobs(const std::filesystem::path& root = "/");

// Counts the processes of our own group that the kernel has ended because memory ran out.
long ended_for_memory();
long ended_for_memory(const std::filesystem::path& group);

}  // namespace grader::sandbox

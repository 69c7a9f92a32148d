// STAFF ONLY. The right to write to a folder of grades: one process at a time has it, until this object's
// destructor or the end of the process, however it ends.
#pragma once

#include <atomic>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>

#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline class_folder {

inline constexpr const char* kFolderLock = ".lock";  // no submission has this name

[[noreturn]] void can_not_write(const std::filesystem::path& folder,
                                const std::string& why);  // throws BadInput

class FolderLock {
 public:
  // Waits while another process has it, and says so once on `says`. Returns nothing if `interrupted` was set
  // meanwhile. Throws BadInput for a folder that can't be written.
  static std::optional<FolderLock> take(const std::filesystem::path& folder,
                                        const std::atomic<bool>& interrupted, std::ostream& says);

 private:
  explicit FolderLock(Descriptor lock) : lock_(std::move(lock)) {}

  Descriptor lock_;  // the kernel releases it when it is closed
};

}  // namespace grader::class_folder

// STAFF ONLY. The right to write to a folder of grades: one process at a time has it, until the end of this
// object's life or of the process, however that ends.
#pragma once

#include <atomic>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>

#include "grader/sandbox/descriptor.h"

namespace grader::inline tool {

inline constexpr const char* kFolderLock = ".lock";  // no submission is called so

[[noreturn]] void can_not_write(const std::filesystem::path& folder,
                                const std::string& why);  // throws BadInput

class FolderLock {
 public:
  // While another process has it, waits, and says so once on `says`. Nothing if `interrupted` was set
  // meanwhile. Throws BadInput for a folder that can't be written.
  static std::optional<FolderLock> take(const std::filesystem::path& folder,
                                        const std::atomic<bool>& interrupted, std::ostream& says);

 private:
  explicit FolderLock(Descriptor lock) : lock_(std::move(lock)) {}

  Descriptor lock_;  // the kernel releases it when it is closed
};

}  // namespace grader::tool

// STAFF ONLY. The folder of grades as something that several people use: one hairgrade at a time writes to it, and
// all that do agree on the course, the suite and the secret.
#pragma once

#include <atomic>
#include <filesystem>
#include <iosfwd>
#include <optional>

#include "grader/sandbox/descriptor.h"
#include "grader/tool/made_by.h"

namespace grader {

// Names in the folder. No submission is called so.
inline constexpr const char* kMadeBy = "made-by.json";
inline constexpr const char* kFolderLock = ".lock";

// Throws BadInput if the folder has results that were made otherwise, or that don't say how they were made. It
// writes nothing, and needs no lock: made-by.json is there before the first result.
void check_made_by(const std::filesystem::path& folder, const MadeBy& mine);

// The right to write to a folder, until the end of this object's life or of the process, however that ends.
class FolderOfGrades {
 public:
  // Makes the folder if it is not there. While another process has it, waits, and says so once on `says`.
  // Nothing if `interrupted` was set meanwhile. Throws BadInput as check_made_by does, and for a folder that can't
  // be written.
  static std::optional<FolderOfGrades> open(const std::filesystem::path& folder, const MadeBy& mine,
                                            const std::atomic<bool>& interrupted, std::ostream& says);

 private:
  explicit FolderOfGrades(Descriptor lock) : lock_(std::move(lock)) {}

  Descriptor lock_;  // the kernel releases it when it is closed
};

}  // namespace grader

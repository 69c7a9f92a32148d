// STAFF ONLY. A folder of grades that several people use: one hairgrade at a time writes to it, and all of
// them agree on the course, the suite and the secret.
#pragma once

#include <atomic>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>
#include <utility>

#include "grader/grading/made_by.h"
#include "grader/record/record.h"
#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline class_folder {

// This is the right to write to a folder of grades: one process at a time has it, until this object's
// destructor or the end of the process, however it ends.
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

// Holds the right to write to a folder, and its record, until this object's destructor or the end of the
// process, however it ends.
class FolderOfGrades {
 public:
  // Makes the folder if it is missing. Waits while another process has it, and says so once on `says`.
  // Returns nothing if `interrupted` was set meanwhile. Throws BadInput if results of this hand-in in the
  // folder were made otherwise (with `regrade`: with another secret), or by an older version without a
  // record; if a hand-in has a name here but none there; and for a folder that can't be written.
  static std::optional<FolderOfGrades> open(const std::filesystem::path& folder, const MadeBy& mine,
                                            const std::atomic<bool>& interrupted, std::ostream& says,
                                            const std::string& hand_in = "", bool regrade = false);

  // Removes a folder that it made if its record has no submission, and no cluster grades some.
  ~FolderOfGrades();
  FolderOfGrades(FolderOfGrades&&) = default;

  Record& record() const { return *record_; }

 private:
  FolderOfGrades(FolderLock lock, const std::filesystem::path& folder, bool made, const std::string& hand_in)
      : lock_(std::move(lock)),
        record_(std::make_unique<Record>(folder, hand_in)),
        made_(made ? folder : std::filesystem::path()) {}

  FolderLock lock_;
  std::unique_ptr<Record> record_;
  std::filesystem::path made_;  // is the folder, if it was missing
};

}  // namespace grader::class_folder

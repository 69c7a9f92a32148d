// STAFF ONLY. A folder of grades that several people use: one hairgrade at a time writes to it, and all of
// them agree on the course, the suite and the secret.
#pragma once

#include <atomic>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>

#include "grader/record/record.h"
#include "grader/tool/folder_lock.h"
#include "grader/tool/made_by.h"

namespace grader::inline tool {

// The right to write to a folder, and its record, until the end of this object's life or of the process,
// however that ends.
class FolderOfGrades {
 public:
  // Makes the folder if it is not there. While another process has it, waits, and says so once on `says`.
  // Nothing if `interrupted` was set meanwhile. Throws BadInput if the folder has results of this hand-in
  // that were made otherwise, or that are of an older version and in no record; if a hand-in has a name here
  // and none there; and for a folder that can't be written.
  static std::optional<FolderOfGrades> open(const std::filesystem::path& folder, const MadeBy& mine,
                                            const std::atomic<bool>& interrupted, std::ostream& says,
                                            const std::string& hand_in = "");

  // A folder that it made goes again if no row is in it.
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
  std::filesystem::path made_;  // the folder, if it was not there before
};

}  // namespace grader::tool

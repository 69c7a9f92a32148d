// STAFF ONLY. Makes folders with a lock in them, and removes those whose lock nobody holds.
#include "grader/sandbox/processes/staging_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "grader/sandbox/processes/identity.h"
#include "hair/io/files/bad_input.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBeginning = "hairgrade-";
constexpr const char* kLockFile = "lock";

// Removes folders of killed graders.
void remove_stale() {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::temp_directory_path(), error)) {
    if (!entry.path().filename().string().starts_with(kBeginning) || entry.is_symlink(error)) continue;
    const Descriptor lock(open((entry.path() / kLockFile).c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC));
    if (lock && flock(lock.get(), LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry.path(), error);
  }
}

}  // namespace

StagingFolder::StagingFolder() {
  remove_stale();
  // Until we hold the lock, another grader may take the new folder for a stale one and remove it.
  do {
    std::string pattern = (fs::temp_directory_path() / (std::string(kBeginning) + "XXXXXX")).string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw hair::BadInput(pattern + ": can't make a folder for temporary files: " + std::strerror(errno));
    path_ = pattern;
    lock_ = Descriptor(open((path_ / kLockFile).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    flock(lock_.get(), LOCK_EX);
  } while (!fs::exists(path_ / kLockFile));
  share_with_sandbox(path_, false);
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace grader::sandbox

// STAFF ONLY. Takes the lock of a folder of grades.
#include "grader/class_folder/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <ostream>
#include <system_error>
#include <thread>

#include "grader/course/input.h"

namespace grader::inline class_folder {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{100};

}  // namespace

void can_not_write(const std::filesystem::path& folder, const std::string& why) {
  throw BadInput(printable(folder.string(), 4096) + ": reports can't be written there: " + why +
                 "; name a folder that can be written with --out");
}

std::optional<FolderLock> FolderLock::take(const std::filesystem::path& folder,
                                           const std::atomic<bool>& interrupted, std::ostream& says) {
  // No program that we start inherits it, so a killed hairgrade's workers do not keep the lock.
  Descriptor lock(::open((folder / kFolderLock).c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644));
  if (!lock) can_not_write(folder, std::generic_category().message(errno));
  bool said = false;
  while (flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) can_not_write(folder, std::generic_category().message(errno));
    if (interrupted) return {};
    if (!said)
      says << "hairgrade: " << printable(folder.string(), 4096)
           << " is in use by another hairgrade; waiting until it has finished\n"
           << std::flush;
    said = true;
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return FolderLock(std::move(lock));
}

}  // namespace grader::class_folder

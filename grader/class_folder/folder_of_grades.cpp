// STAFF ONLY. Opens a folder of grades, and compares how its grades were made.
#include "grader/class_folder/folder_of_grades.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <ostream>
#include <system_error>
#include <thread>
#include <vector>

#include "grader/class_folder/shared_plan.h"
#include "grader/course/input.h"
#include "grader/record/points/hand_ins.h"

namespace grader::inline class_folder {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolderLock = ".lock";  // no submission has this name

[[noreturn]] void can_not_write(const std::filesystem::path& folder, const std::string& why) {
  throw BadInput(printable(folder.string(), 4096) + ": reports can't be written there: " + why +
                 "; name a folder that can be written with --out");
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& why, const std::string& way) {
  throw BadInput(printable(folder.string(), 4096) + ": " + why + "; " + way +
                 "name another folder with --out, or move this one away to grade all again");
}

// Joins differences as "a; b", and the ways to remove them as "a and b".
void refuse(const fs::path& folder, const std::vector<Difference>& differences, bool same_secret) {
  std::string what, way;
  for (const Difference& one : differences) {
    what += (what.empty() ? "" : "; ") + one.what;
    way += (way.empty() ? "" : " and ") + one.way;
  }
  refuse(folder, "its grades were made with " + what,
         way + " to add to it, " + (same_secret ? "--regrade to grade all of them again in place, " : ""));
}

// Removes unfinished files of a killed hairgrade. No other process writes here.
void remove_half_written(const fs::path& folder) {
  std::vector<fs::path> left;
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(folder, ignored))
    if (const std::string name = entry.path().filename().string();
        name.starts_with('.') && name.ends_with(".part"))
      left.push_back(entry.path());
  for (const fs::path& file : left) fs::remove(file, ignored);
}

// The record stores its settings before the first result.
void check_made_by(const fs::path& folder, const MadeBy& mine, const std::string& hand_in, bool regrade) {
  if (!Record::is_in(folder)) return;
  Record record(folder, hand_in);
  if (hand_in.empty())
    check_hand_in(hand_in, record.named_hand_ins(), printable(folder.string(), 4096));
  else if (!Record(folder).names().empty())
    refuse(
        folder,
        "its grades are of a course with one hand-in without a name, not of \"" + printable(hand_in) + "\"",
        "");
  if (record.names().empty()) return;
  const std::optional<MadeBy> there = made_by_from_json(record.made_by());
  if (!there) refuse(folder, std::string(kRecordFile) + " in it does not say what they were made with", "");
  const bool same_secret = there->secret == mine.secret;
  if (regrade && same_secret) return;
  if (const std::vector<Difference> found = differences(*there, mine); !found.empty())
    refuse(folder, found, same_secret);
}

}  // namespace

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
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return FolderLock(std::move(lock));
}

std::optional<FolderOfGrades> FolderOfGrades::open(const fs::path& folder, const MadeBy& mine,
                                                   const std::atomic<bool>& interrupted, std::ostream& says,
                                                   const std::string& hand_in, bool regrade) {
  std::optional<FolderLock> lock;
  bool made = false;
  do {  // tries again if the last process removed the folder
    std::error_code error;
    made = fs::create_directories(folder, error);
    if (made) fs::permissions(folder, fs::perms::owner_all);  // it holds all grades
    if (error) can_not_write(folder, error.message());
    if (access(folder.c_str(), W_OK) != 0) can_not_write(folder, std::generic_category().message(errno));
    lock = FolderLock::take(folder, interrupted, says);
    if (!lock) return {};
  } while (!fs::exists(folder / kFolderLock));
  check_made_by(folder, mine, hand_in, regrade);
  remove_half_written(folder);
  FolderOfGrades opened(std::move(*lock), folder, made, hand_in);
  // A regrade changes it with the results.
  if (!regrade || opened.record().names().empty()) opened.record().set_made_by(to_json(mine));
  return opened;
}

FolderOfGrades::~FolderOfGrades() {
  if (!record_ || made_.empty()) return;
  try {
    if (!record_->names().empty() || SharedPlan::in(made_)) return;
    record_.reset();
    fs::remove_all(made_);
  } catch (const std::exception&) {  // leaves an empty folder
  }
}

}  // namespace grader::class_folder

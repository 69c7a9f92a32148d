// STAFF ONLY. Chooses the users that run student code, and shares folders with them.
#include "grader/sandbox/processes/identity.h"

#include <fcntl.h>
#include <grp.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#include "hair/io/files/bad_input.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

struct Range {
  std::uint64_t first = 0, end = 0;
  bool holds(std::uint64_t number) const { return first <= number && number < end; }
};

// Reads /proc/self/uid_map or gid_map: lines of "first, first outside, count".
std::vector<Range> ranges_of(const char* map) {
  std::ifstream in(map);
  if (!in) return {{0, UINT32_MAX}};  // there are no namespaces
  std::vector<Range> ranges;
  for (std::uint64_t first = 0, outside = 0, count = 0; in >> first >> outside >> count;)
    ranges.push_back({first, first + count});
  return ranges;
}

bool has_number(const char* map, std::uint64_t number) {
  const std::vector<Range> ranges = ranges_of(map);
  return std::ranges::any_of(ranges, [&](const Range& range) { return range.holds(number); });
}

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

Identity sandbox_identity() {
  if (geteuid() != 0) return {geteuid(), getegid(), false};
  if (!has_number("/proc/self/uid_map", kSandboxUser) || !has_number("/proc/self/gid_map", kSandboxUser))
    throw hair::BadInput(
        "this root belongs to a user namespace without the user and group " + std::to_string(kSandboxUser) +
        ", who run student code (unshare -Ur makes such a root); run hairgrade as an ordinary user, or as "
        "root of the machine");
  return {kSandboxUser, kSandboxUser, true};
}

Identity identity_of_a_run() {
  if (geteuid() != 0) throw hair::BadInput("only root can give each run a user of its own");
  // Accounts have lower numbers, and some programs read higher ones as negative.
  constexpr std::uint64_t kFirst = 1U << 30, kEnd = (1U << 31) - 2;
  // A container may have few numbers: these are above Debian's for accounts and services.
  constexpr std::uint64_t kFirstOfFew = 60'000, kEndOfFew = 65'500;
  for (const Range wanted : {Range{kFirst, kEnd}, Range{kFirstOfFew, kEndOfFew}}) {
    std::random_device device;
    const auto number = static_cast<uid_t>(
        std::uniform_int_distribution<std::uint64_t>(wanted.first, wanted.end - 1)(device) &
        ~std::uint64_t{1});
    // The user with the next number ends this one's processes: see supervisor.cpp.
    if (has_number("/proc/self/uid_map", number) && has_number("/proc/self/uid_map", number + 1) &&
        has_number("/proc/self/gid_map", number))
      return {number, number, true};
  }
  throw hair::BadInput("this root has no numbers of users to give to runs (see /proc/self/uid_map)");
}

bool become(const Identity& identity) {
  if (!identity.changes) return true;
  return setgroups(0, nullptr) == 0 && setresgid(identity.group, identity.group, identity.group) == 0 &&
         setresuid(identity.user, identity.user, identity.user) == 0;
}

void share_with_sandbox(const std::filesystem::path& folder, bool writable) {
  const Identity identity = sandbox_identity();
  if (identity.changes && chown(folder.c_str(), writable ? identity.user : 0, identity.group) != 0)
    throw hair::BadInput(
        folder.string() + ": can't be given to the user " + std::to_string(identity.user) +
        ", who runs student code (" + std::generic_category().message(errno) +
        "); give root the right to change owners (CAP_CHOWN), or run hairgrade as an ordinary user");
  if (chmod(folder.c_str(), identity.changes ? 0750 : 0700) != 0)
    throw std::system_error(errno, std::generic_category(), "chmod " + folder.string());
}

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

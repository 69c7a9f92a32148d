// STAFF ONLY. Makes root folders of links and copies.
#include "grader/sandbox/container_root.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <string>
#include <system_error>

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* what, const fs::path& path) {
  throw fs::filesystem_error(what, path, std::error_code(errno, std::generic_category()));
}

Descriptor locked(const fs::path& file, int how) {
  Descriptor lock(open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (!lock) fail("can't lock", file);
  if (flock(lock.get(), how) != 0) lock.close();
  return lock;
}

// Makes a folder that everybody can read, whatever the umask is.
void make_folder(const fs::path& folder) {
  if (mkdir(folder.c_str(), 0755) != 0 && errno != EEXIST) fail("can't make the folder", folder);
  if (chmod(folder.c_str(), 0755) != 0) fail("can't change the mode of", folder);
}

void copy_for_all(const fs::path& source, const fs::path& target) {
  fs::copy_file(source, target);
  fs::permissions(target, fs::perms(0755));
}

// Calls `put` with each regular file and its new place.
void put_tree(const fs::path& source, const fs::path& target,
              const std::function<void(const fs::path&, const fs::path&)>& put) {
  if (fs::is_symlink(source)) return fs::copy_symlink(source, target);
  if (!fs::is_directory(source)) return put(source, target);
  make_folder(target);
  for (const fs::directory_entry& entry : fs::directory_iterator(source))
    put_tree(entry.path(), target / entry.path().filename(), put);
}

void link_or_copy(const fs::path& source, const fs::path& target) {
  if (link(source.c_str(), target.c_str()) != 0) copy_for_all(source, target);
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

// Returns the copy of a file or folder of the system.
fs::path system_copy(const fs::path& roots, const fs::path& source) {
  const fs::path system = roots / "system", copy = system / source.relative_path();
  const Descriptor lock = locked(roots / "system.lock", LOCK_EX);
  if (fs::exists(fs::symlink_status(copy))) return copy;
  make_folder(system);
  fs::path folder = system;
  for (const fs::path& part : source.relative_path().parent_path()) make_folder(folder /= part);
  const fs::path unfinished = roots / "unfinished";  // another process left it unfinished
  fs::remove_all(unfinished);
  put_tree(source, unfinished, copy_for_all);
  fs::rename(unfinished, copy);
  return copy;
}

// Gives a run's files to root: folders, and regular files with one name. It removes everything else.
void take_over(const fs::path& path) {
  struct stat status = {};
  if (lstat(path.c_str(), &status) != 0) return;
  const bool folder = S_ISDIR(status.st_mode);
  if (!folder && (!S_ISREG(status.st_mode) || status.st_nlink != 1)) {
    unlink(path.c_str());
    return;
  }
  if (lchown(path.c_str(), 0, 0) != 0 || chmod(path.c_str(), folder ? 0755 : 0644) != 0)
    fail("can't take over", path);
  if (folder)
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) take_over(entry.path());
}

}  // namespace

ContainerRoot::ContainerRoot(const Sandbox& sandbox, const Identity& user) : roots_(sandbox.roots) {
  // The other files beside the roots are the grader's own; links may lead to them.
  const fs::path own = roots_.parent_path();
  std::vector<Mount> lasting;
  for (const Mount& mount : sandbox.mounts)
    if (!is_below(mount.source, own)) lasting.push_back(mount);
  take_root(lasting);
  for (const Mount& mount : sandbox.mounts) {
    if (!is_below(mount.source, own)) continue;
    mount.writable ? lend(mount, user) : add(mount.source, mount.target, false);
  }
  if (sandbox.tmp_bytes > 0) {
    const fs::path tmp = path_ / "tmp";
    add_folder(tmp, false);
    if (chown(tmp.c_str(), user.user, user.group) != 0) fail("can't give away", tmp);
    // If /dev/null can't be made, no program of ours needs it.
    const fs::path null = path_ / "dev" / "null";
    add_folder(null.parent_path(), true);
    if (mknod(null.c_str(), S_IFCHR | 0666, makedev(1, 3)) == 0) chmod(null.c_str(), 0666);
  }
}

ContainerRoot::~ContainerRoot() {
  std::error_code ignored;
  for (const Mount& mount : lent_) {
    const fs::path folder = path_ / fs::path(mount.target).relative_path();
    try {
      take_over(folder);
    } catch (const fs::filesystem_error&) {
      fs::remove_all(folder, ignored);  // its contents can't be trusted
    }
    fs::rename(folder, mount.source, ignored);
  }
  for (; !made_.empty(); made_.pop_back()) fs::remove_all(made_.back(), ignored);
}

void ContainerRoot::take_root(const std::vector<Mount>& lasting) {
  std::string all;
  for (const Mount& mount : lasting) all += mount.source.string() + '\0' + mount.target + '\0';
  const std::string key = std::to_string(std::hash<std::string>()(all));
  make_folder(roots_);
  for (int number = 0; !lock_; ++number) {
    path_ = roots_ / (key + "-" + std::to_string(number));
    lock_ = locked(path_.string() + ".lock", LOCK_EX | LOCK_NB);
  }
  const fs::path whole = path_.string() + ".whole";
  if (fs::exists(whole)) return;
  fs::remove_all(path_);
  make_folder(path_);
  for (const Mount& mount : lasting) add(system_copy(roots_, mount.source), mount.target, true);
  Descriptor(open(whole.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
}

void ContainerRoot::add_folder(const fs::path& folder, bool lasting) {
  fs::path now = path_;
  for (const fs::path& part : folder.lexically_relative(path_)) {
    now /= part;
    if (fs::exists(now)) continue;
    make_folder(now);
    if (!lasting) made_.push_back(now);
  }
}

void ContainerRoot::add(const fs::path& source, const std::string& target, bool lasting) {
  const fs::path place = path_ / fs::path(target).relative_path();
  add_folder(place.parent_path(), lasting);
  // A later mount hides an earlier one.
  if (fs::exists(fs::symlink_status(place))) fs::remove_all(place);
  put_tree(source, place, link_or_copy);
  if (!lasting) made_.push_back(place);
}

void ContainerRoot::lend(const Mount& mount, const Identity& user) {
  const fs::path place = path_ / fs::path(mount.target).relative_path();
  add_folder(place.parent_path(), false);
  fs::rename(mount.source, place);
  lent_.push_back(mount);
  if (chown(place.c_str(), user.user, user.group) != 0 || chmod(place.c_str(), 0700) != 0)
    fail("can't give away", place);
}

}  // namespace grader::sandbox

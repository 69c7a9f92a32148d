// STAFF ONLY. Copies the grading kit to where the sandbox's user can read it.
#include "grader/compile/kit.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/sandbox/identity.h"

namespace grader {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPrefix = "hairgrade-";
constexpr const char* kLock = "lock";

// Folders of graders that were killed: nobody holds their lock any more.
void remove_stale() {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::temp_directory_path(), error)) {
    if (!entry.path().filename().string().starts_with(kPrefix) || entry.is_symlink(error)) continue;
    const Descriptor lock(open((entry.path() / kLock).c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC));
    if (lock && flock(lock.get(), LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry.path(), error);
  }
}

}  // namespace

StagedKit::StagedKit(const fs::path& kit, const Course& course) {
  std::vector<fs::path> parts = {"worker", "sanitised/worker", "serve/runs.so", "given/standard.a"};
  for (const Exercise& exercise : course.exercises) {
    parts.push_back(fs::path("handout") / exercise.header);
    parts.push_back(fs::path("export") / (exercise.id + ".map"));
    for (const char* folder : {"lib", "stub", "serve"})
      parts.push_back(fs::path(folder) / (exercise.id + ".so"));
    for (const std::string& library : exercise.libraries)
      parts.push_back(fs::path("given") / (library + ".a"));
    for (const std::string& id : exercise.prerequisites) parts.push_back(fs::path("provided") / (id + ".so"));
  }
  for (const fs::path& part : parts)
    if (!fs::exists(kit / part))
      throw BadInput((kit / part).string() + " is missing; build the target grading_kit");

  remove_stale();
  // Another grader may take the new folder for a stale one and remove it, until we hold its lock.
  do {
    std::string pattern = (fs::temp_directory_path() / (std::string(kPrefix) + "XXXXXX")).string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw BadInput(pattern + ": can't make a folder for temporary files: " + std::strerror(errno));
    root_ = pattern;
    lock_ = Descriptor(open((root_ / kLock).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    flock(lock_.get(), LOCK_EX);
  } while (!fs::exists(root_ / kLock));
  share_with_sandbox(root_, false);
  fs::copy(kit, folder(), fs::copy_options::recursive);
  fs::create_directory(empty_folder());
  fs::permissions(empty_folder(), fs::perms(0755));
  for (const auto& entry : fs::recursive_directory_iterator(folder()))
    fs::permissions(entry.path(), fs::perms(0755));
  fs::permissions(folder(), fs::perms(0755));
  hash_ = sha256_of(folder());
}

StagedKit::~StagedKit() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

fs::path StagedKit::new_job(const std::string& name) const {
  const fs::path job = root_ / name;
  fs::create_directory(job);
  share_with_sandbox(job, false);
  return job;
}

}  // namespace grader

// STAFF ONLY.
#include "grader/compile/kit.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>

#include "grader/compile/hash.h"
#include "grader/course/bad_input.h"
#include "grader/sandbox/identity.h"

namespace grader {

namespace fs = std::filesystem;

StagedKit::StagedKit(const fs::path& kit, const Course& course) {
  for (const Exercise& exercise : course.exercises)
    for (const fs::path& part :
         {fs::path("worker"), fs::path("include") / exercise.header, fs::path("lib") / (exercise.id + ".so"),
          fs::path("serve") / (exercise.id + ".so"), fs::path("export") / (exercise.id + ".map")})
      if (!fs::exists(kit / part))
        throw BadInput((kit / part).string() + " is missing; build the target grading_kit");

  std::string pattern = (fs::temp_directory_path() / "hairgrade-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr)
    throw BadInput(pattern + ": can't make a folder for temporary files: " + std::strerror(errno));
  root_ = pattern;
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

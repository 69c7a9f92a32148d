// STAFF ONLY. Copies the grading kit to a folder that the sandbox's user can read.
#include "grader/compile/kit.h"

#include <vector>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/sandbox/processes/identity.h"

namespace grader::inline compile {

namespace fs = std::filesystem;

StagedKit::StagedKit(const fs::path& kit, const Course& course) {
  std::vector<fs::path> parts = {"probe", "worker", "serve/runs.so", "given/standard.a"};
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

  fs::copy(kit, folder(), fs::copy_options::recursive);
  fs::create_directory(empty_folder());
  fs::permissions(empty_folder(), fs::perms(0755));
  for (const auto& entry : fs::recursive_directory_iterator(folder()))
    fs::permissions(entry.path(), fs::perms(0755));
  fs::permissions(folder(), fs::perms(0755));
  hash_ = sha256_of(folder());
}

fs::path StagedKit::new_job(const std::string& name) const {
  const fs::path job = root_.path() / name;
  fs::create_directory(job);
  share_with_sandbox(job, false);
  return job;
}

}  // namespace grader::compile

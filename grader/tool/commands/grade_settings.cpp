// STAFF ONLY. Finds the parts of this build, and asks the machine for a kind of isolation.
#include "grader/tool/commands/grade_settings.h"

#include <algorithm>
#include <cstdlib>

#include "grader/course/input.h"
#include "grader/grading/isolation_here.h"
#include "grader/grading/secret.h"
#include "grader/sandbox/inherited.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

fs::path default_cache() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
    return fs::path(cache) / "hairgrade";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return fs::path(home) / ".cache" / "hairgrade";
  throw BadInput("HOME is not set, so there is no place for compiled objects; name a folder with --cache");
}

std::string asked_for(const Course& course) {
  std::string ids;
  for (const Exercise& exercise : course.exercises)
    if (course.asks_for(exercise)) ids += (ids.empty() ? "" : ", ") + exercise.id;
  return ids;
}

}  // namespace

GradingSettings settings_of(const GradeSettings& options) {
  GradingSettings settings;
  settings.course = read_course(HAIR_EXERCISES_JSON, options.course);
  settings.course.of_hand_in = options.of_hand_in;
  if (options.exercise) {
    const Exercise* exercise = settings.course.find(*options.exercise);
    if (exercise == nullptr || !settings.course.asks_for(*exercise))
      throw BadInput("--exercise " + *options.exercise + ": the course does not ask for it; it asks for " +
                     asked_for(settings.course));
  }
  if (options.study && options.exercise)
    throw BadInput("--study: it needs all exercises; leave out --exercise " + *options.exercise);
  if (options.study && !std::filesystem::exists(HAIR_STUDY))
    throw BadInput("--study: hairstudy is not built; ./grader/grade builds it for --study");
  settings.exercise = options.exercise;
  settings.kit = HAIR_KIT_DIR;
  settings.suite = HAIR_SUITE;
  settings.study_program = HAIR_STUDY;
  settings.runners = HAIR_RUNNERS;
  settings.scenes = HAIR_HIDDEN_SCENES;
  settings.reference = fs::path(HAIR_SOURCE_DIR) / "reference";
  settings.images = !options.no_images;
  settings.study = options.study;
  const Budget& budget = settings.course.budget;
  // Without a sandbox this error comes first, before those about archives.
  settings.isolation = isolation_here(StagedKit(settings.kit, settings.course), options.isolation);
  require_hard_limits({.jobs = options.jobs,
                       .cpu_seconds = std::max({budget.worker_cpu_seconds, budget.compiler_cpu_seconds,
                                                budget.suite_cpu_seconds})});
  settings.cache = options.cache ? *options.cache : default_cache();
  settings.secret = read_secret(options.secret);
  return settings;
}

}  // namespace grader::tool

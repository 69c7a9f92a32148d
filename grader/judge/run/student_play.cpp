// STAFF ONLY. Loads the reference's runner, and lets a worker answer for the student's exercise.
#include "grader/judge/run/student_play.h"

#include <dlfcn.h>

#include <stdexcept>

namespace grader::inline judge {

PlayFunction load_runner(const std::filesystem::path& runner) {
  void* object = dlopen(runner.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* function = object == nullptr ? nullptr : dlsym(object, kRunnerName);
  if (function == nullptr) throw std::runtime_error(std::string("no runner: ") + dlerror());
  return reinterpret_cast<PlayFunction>(function);
}

Played play_with_student(Trial& trial, const std::filesystem::path& runner, const hair::Scene& scene) {
  const Ask ask = [&](const MessageWriter& request, const Products& products) {
    return trial.ask(request, products,
                     "asks for far more products or forces in a run than a solution takes");
  };
  PlayResult play;
  load_runner(runner)(scene, ask, play);
  if (play.end == PlayEnd::malformed) throw MalformedMessage(play.note);
  if (play.end == PlayEnd::threw)
    trial.fail(Status::crashed, "the scene can't go on with its numbers", play.note);
  return std::move(play.played);
}

}  // namespace grader::judge

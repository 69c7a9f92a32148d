// STAFF ONLY. Runs a scene with a worker, and limits how long a study goes on.
#include "grader/judge/study/runner.h"

#include <chrono>

namespace grader::inline judge {

Play WorkerRunner::play(const SceneText& text, const hair::Scene& scene, int times) {
  Trial trial(student_, Random("", text.name));
  trial.describe(text.name);
  Play play;
  play.played = play_elsewhere(trial, text.json, scene, times);
  const double now = student_.worker_cpu_seconds().value_or(0);
  if (starts_ == student_.starts() && now > clock_) play.seconds = now - clock_;
  starts_ = student_.starts();
  clock_ = now;
  return play;
}

Play UntilItGivesUp::play(const SceneText& text, const hair::Scene& scene, int times) {
  using Clock = std::chrono::steady_clock;
  if (wall_left_ <= 0 && !end_)
    end_ = CaseFailed{Status::timed_out, "the code takes too long by the clock on the wall", ""};
  if (end_) throw CaseFailed(*end_);
  struct Charge {
    double& left;
    Clock::time_point start = Clock::now();
    ~Charge() { left -= std::chrono::duration<double>(Clock::now() - start).count(); }
  } charge{wall_left_};
  try {
    return runner_.play(text, scene, times);
  } catch (const CaseFailed& failure) {
    crashes_ += failure.status == Status::crashed;
    if (failure.status == Status::timed_out || failure.status == Status::broke_rules ||
        crashes_ >= kMostCrashes)
      end_ = failure;
    throw;
  }
}

}  // namespace grader::judge

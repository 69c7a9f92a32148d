#include "hair/lab/study/method_runner.h"

#include <algorithm>
#include <exception>
#include <numeric>

#include "hair/io/files/printable.h"
#include "hair/io/plot/page.h"
#include "solver/not_implemented.h"
#include "solver/timing.h"

namespace hair {

namespace {

constexpr int kMostTimes = 1000;  // between two looks at the clock

bool once_more(const std::vector<double>& seconds, const Repeats& repeats) {
  const int times = static_cast<int>(seconds.size());
  const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  if (times < repeats.least) return sum < repeats.too_long;
  return times < repeats.most && sum < repeats.enough;
}

}  // namespace

double MethodRun::time() const {
  return timing::median(seconds);
}

MethodRunner::MethodRunner(const Problem& problem, const StudyMethod& method, const Trajectory& accurate,
                           const Errors& floors)
    : problem_(problem),
      method_(method),
      accurate_(accurate),
      floors_(floors),
      scene_run_(std::make_unique<SceneRun>(with_method(problem, method, 1))) {}

bool MethodRunner::compare(const Scene& scene, const std::atomic<bool>& interrupted, MethodRun& run) {
  const double useless = size_of(problem_);
  ErrorTally tally(problem_, accurate_);
  scene_run_->restart(scene);
  tally.add(*scene_run_);
  run.seconds = {0};
  while (scene_run_->frame() < scene.frames) {
    if (interrupted) return false;
    const double start = timing::cpu_seconds();
    const std::optional<std::string> trouble = scene_run_->advance();
    run.seconds[0] += timing::cpu_seconds() - start;
    if (trouble) {
      run.ending = RunEnding::broke;
      run.trouble = *trouble;
      return true;
    }
    const double off = tally.add(*scene_run_);
    if (!(off <= useless)) {
      run.ending = RunEnding::useless;
      run.trouble = to_text(off) + " m off after " + to_text(scene_run_->time()) + " s";
      return true;
    }
  }
  run.errors = tally.errors();
  for (int k = 0; k < kNorms; ++k) {
    const Norm norm = static_cast<Norm>(k);
    if (run.errors[norm] < floors_[norm]) run.errors[norm] = 0;
  }
  return true;
}

std::optional<double> MethodRunner::play(const Scene& scene, int times, int advances,
                                         const std::atomic<bool>& interrupted) {
  const double start = timing::cpu_seconds();
  for (int i = 0; i < times; ++i) {
    scene_run_->restart(scene);
    for (int k = 0; k < advances; ++k) {
      if (interrupted) return {};
      scene_run_->advance();
    }
  }
  return timing::cpu_seconds() - start;
}

bool MethodRunner::repeat(const Scene& scene, const Repeats& repeats, const std::atomic<bool>& interrupted,
                          MethodRun& run) {
  // A run that broke or became useless did so on the way to its next moment, or at it.
  const int advances = scene_run_->frame() + (run.ending == RunEnding::broke ? 1 : 0);
  const double once = run.seconds[0];
  const int times = std::clamp(static_cast<int>(repeats.clock / std::max(once, 1e-9)), 1, kMostTimes);
  std::vector<double> seconds;
  if (once >= repeats.warm) seconds.push_back(once);
  while (once_more(seconds, repeats)) {
    const auto all = play(scene, times, advances, interrupted);
    const auto restarts = play(scene, times, 0, interrupted);
    if (!all || !restarts) return false;
    seconds.push_back(std::max(0.0, *all - *restarts) / times);
  }
  run.seconds = seconds;
  return true;
}

std::optional<MethodRun> MethodRunner::run(int steps_per_moment, const Repeats& repeats,
                                           const std::atomic<bool>& interrupted) {
  const Scene scene = with_method(problem_, method_, steps_per_moment);
  MethodRun run;
  run.steps_per_moment = steps_per_moment;
  run.step = scene.hair.step;
  try {
    if (!compare(scene, interrupted, run)) return {};
    count(run);
    if (!repeat(scene, repeats, interrupted, run)) return {};
  } catch (const NotImplemented&) {
    throw;
  } catch (const std::exception& error) {
    run.ending = RunEnding::broke;
    run.trouble = "step " + std::to_string(scene_run_->steps()) + ": threw " + printable(error.what());
    run.errors = {};
    count(run);
  }
  return run;
}

void MethodRunner::count(MethodRun& run) const {
  const Work work = scene_run_->work();
  Counts& counts = run.counts;
  counts.steps = scene_run_->steps();
  counts.iterations = work.solver_steps;
  counts.corrections = work.correction_steps;
  counts.evaluations = counts.steps * row_of(method_.method).evaluations;
  counts.unconverged = work.unconverged;
}

}  // namespace hair

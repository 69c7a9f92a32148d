#include "hair/study/method_runner.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "hair/plot/page.h"
#include "hair/study/cpu_time.h"

namespace hair {

namespace {

// What a step's evaluations of the forces are, by the contracts of P1, H4 and H6, and to begin with.
long evaluations_of_a_step(Method method) {
  switch (method) {
    case Method::midpoint:
    case Method::predictor_corrector:  // for each of its two solves one
      return 2;
    case Method::runge_kutta_4:
      return 4;
    default:
      return 1;
  }
}

bool once_more(const std::vector<double>& seconds, const Repeats& repeats) {
  const int times = static_cast<int>(seconds.size());
  const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  if (times < repeats.least) return sum < repeats.too_long;
  return times < repeats.most && sum < repeats.enough;
}

}  // namespace

double MethodRun::time() const {
  std::vector<double> sorted = seconds;
  if (sorted.empty()) return 0;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

MethodRunner::MethodRunner(const Problem& problem, const StudyMethod& method, const Trajectory& accurate)
    : problem_(problem),
      method_(method),
      accurate_(accurate),
      playback_(std::make_unique<Playback>(with_method(problem, method, 1))) {}

bool MethodRunner::play(const Scene& scene, int advances, const std::atomic<bool>& interrupted,
                        MethodRun& run, const std::function<bool(const std::optional<std::string>&)>& look) {
  playback_->restart(scene);
  double seconds = 0;
  for (int k = 0; k < advances; ++k) {
    if (interrupted) return false;
    const double start = cpu_seconds();
    const std::optional<std::string> trouble = playback_->advance();
    seconds += cpu_seconds() - start;
    if (look && !look(trouble)) break;
  }
  run.seconds.push_back(seconds);
  return true;
}

std::optional<MethodRun> MethodRunner::run(int steps_per_moment, const Repeats& repeats,
                                           const std::atomic<bool>& interrupted) {
  const Scene scene = with_method(problem_, method_, steps_per_moment);
  MethodRun run;
  run.steps_per_moment = steps_per_moment;
  run.step = scene.hair.step;

  const double useless = size_of(problem_);
  ErrorTally tally(problem_, accurate_);
  int advances = 0;
  const auto look = [&](const std::optional<std::string>& trouble) {
    ++advances;
    if (trouble) {
      run.ending = RunEnding::broke;
      run.trouble = *trouble;
      return false;
    }
    const double off = tally.add(*playback_);
    if (off <= useless) return true;
    run.ending = RunEnding::useless;
    run.trouble = to_text(off) + " m off after " + to_text(playback_->time()) + " s";
    return false;
  };
  playback_->restart(scene);
  tally.add(*playback_);
  if (!play(scene, scene.frames, interrupted, run, look)) return {};
  if (run.ending == RunEnding::finished) run.errors = tally.errors();
  count(run);

  if (run.seconds[0] < repeats.warm) run.seconds.clear();
  while (once_more(run.seconds, repeats))
    if (!play(scene, advances, interrupted, run, {})) return {};
  return run;
}

void MethodRunner::count(MethodRun& run) const {
  const Work work = playback_->work();
  Counts& counts = run.counts;
  counts.steps =
      problem_.is_toy() ? static_cast<long>(playback_->frame()) * run.steps_per_moment : work.strand_steps;
  counts.iterations = work.solver_steps;
  counts.corrections = work.correction_steps;
  counts.evaluations = counts.steps * evaluations_of_a_step(method_.method);
  // Each of its Newton steps looks where it led to.
  if (method_.method == Method::newton_euler) counts.evaluations += counts.corrections;
  counts.unconverged = work.unconverged;
}

}  // namespace hair

#include "hair/lab/study/written_down.h"

#include <cmath>

namespace hair {

void add_written_down(const Problem& problem, Study& study, const std::atomic<bool>& interrupted) {
  const std::vector<Sweep> sweeps = study.sweeps;
  for (const Sweep& sweep : sweeps) {
    Sweep written{sweep.method, {}, sweep.end, {}};
    written.method.id += "-written";
    written.method.name += ", written down";
    for (MethodRun run : sweep.runs) {
      if (interrupted) return;
      if (run.ending != RunEnding::finished) continue;
      const auto other = run_written_down(problem, sweep.method, run.steps_per_moment);
      if (!other) break;
      const double error = largest_distance(other->x, study.reference.states.back().x),
                   expected = run.errors[Norm::final_largest];
      if (!(std::abs(error - expected) <= 0.01 * expected + study.floors[Norm::final_largest])) continue;
      run.seconds = {other->seconds};
      written.runs.push_back(run);
    }
    if (!written.runs.empty()) study.sweeps.push_back(written);
  }
}

}  // namespace hair

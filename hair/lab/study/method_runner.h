// Runs a method on a problem, and measures its distance from the accurate motion and its cost.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "hair/lab/study/study.h"
#include "hair/truth/accurate_motion.h"

namespace hair {

// How often a run is repeated to measure its time. The first, measured run of a short problem only warms up
// and its time does not count, because it evaluates errors and reads a clock between the moments.
struct Repeats {
  int most = 7;
  double enough = 0.15;   // s of CPU time together: after that it is not repeated again,
  int least = 3;          // but at least this often,
  double too_long = 0.2;  // s, if it takes no longer than this
  double warm = 0.05;     // s: a run that takes this long needs no separate warm-up
  double clock = 1e-3;    // s between two readings of the clock: shorter runs are repeated in a row
};

class MethodRunner {
 public:
  // Assembles the problem with the method, once for all steps. Keeps a reference to the accurate states,
  // which have the problem's moments. Throws std::invalid_argument if the problem can't be assembled.
  MethodRunner(const Problem& problem, const StudyMethod& method, const Trajectory& accurate,
               const Errors& floors);

  // Empty if interrupted. Passes on exceptions of stubs; any other exception of an exercise counts as a
  // failed run. Times include only the steps, not the measurements. Errors below the floors are set to 0.
  std::optional<MethodRun> run(int steps_per_moment, const Repeats& repeats,
                               const std::atomic<bool>& interrupted);

 private:
  // Runs once and records errors and time, or the reason why it did not reach its end. All return false if
  // interrupted.
  bool compare(const Scene& scene, const std::atomic<bool>& interrupted, MethodRun& run);
  bool repeat(const Scene& scene, const Repeats& repeats, const std::atomic<bool>& interrupted,
              MethodRun& run);
  // Runs from the start, `times` times, `advances` moments each: the total CPU time, s.
  std::optional<double> play(const Scene& scene, int times, int advances,
                             const std::atomic<bool>& interrupted);
  void count(MethodRun& run) const;

  const Problem& problem_;
  StudyMethod method_;
  const Trajectory& accurate_;
  Errors floors_;
  std::unique_ptr<SceneRun> scene_run_;
};

}  // namespace hair

// Runs a method on a problem, and measures: how far it is from the accurate motion, what it takes.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "hair/lab/study/study.h"
#include "hair/truth/accurate_motion.h"

namespace hair {

// How often a run is repeated for its time. The first time of a short one is to warm up, and does not count: what looks
// at its moments is between them, and a clock at each.
struct Repeats {
  int most = 7;
  double enough = 0.15;   // s of CPU time together: then it is not repeated again,
  int least = 3;          // but so often,
  double too_long = 0.2;  // s, if it takes no longer
  double warm = 0.05;     // s: a run that takes as long has warmed up by itself
  double clock = 1e-3;    // s between two looks at the clock: shorter runs are played many times in a row
};

class MethodRunner {
 public:
  // Assembles the problem with the method, once for all steps. Refers to the accurate states, which have the
  // problem's moments. Throws std::invalid_argument for what can't be assembled.
  MethodRunner(const Problem& problem, const StudyMethod& method, const Trajectory& accurate,
               const Errors& floors);

  // Empty if interrupted. What a stub throws, passes; an exercise that throws something else breaks the run. Times are
  // of the steps alone, and not of what measures them. Errors below the floors are 0.
  std::optional<MethodRun> run(int steps_per_moment, const Repeats& repeats,
                               const std::atomic<bool>& interrupted);

 private:
  // Once, with errors and the time; of one that gets not to its end, why. All false if interrupted.
  bool compare(const Scene& scene, const std::atomic<bool>& interrupted, MethodRun& run);
  bool repeat(const Scene& scene, const Repeats& repeats, const std::atomic<bool>& interrupted,
              MethodRun& run);
  // From the start, so many times, so many moments: s of CPU time of all that.
  std::optional<double> play(const Scene& scene, int times, int advances,
                             const std::atomic<bool>& interrupted);
  void count(MethodRun& run) const;

  const Problem& problem_;
  StudyMethod method_;
  const Trajectory& accurate_;
  Errors floors_;
  std::unique_ptr<Playback> playback_;
};

}  // namespace hair

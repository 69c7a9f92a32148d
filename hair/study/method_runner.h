// Runs a method on a problem, and measures: how far it is from the accurate motion, what it takes.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hair/study/accurate_motion.h"
#include "hair/study/study.h"

namespace hair {

// How often a run is repeated for its time. The first time of a short one is to warm up, and does not count.
struct Repeats {
  int most = 7;
  double enough = 0.2;    // s of CPU time together: then it is not repeated again,
  int least = 3;          // but so often,
  double too_long = 0.6;  // s, if it takes no longer
  double warm = 0.05;     // s: a run that takes as long has warmed up by itself
};

class MethodRunner {
 public:
  // Assembles the problem with the method, once for all steps. Refers to the accurate states, which have the
  // problem's moments. Throws std::invalid_argument for what can't be assembled.
  MethodRunner(const Problem& problem, const StudyMethod& method, const Trajectory& accurate);

  // Empty if interrupted. What a stub throws, passes. Times are of the steps alone, and not of what measures
  // them.
  std::optional<MethodRun> run(int steps_per_moment, const Repeats& repeats,
                               const std::atomic<bool>& interrupted);

 private:
  // From the start, so many moments, unless `look`, if there is one, says false of one. Adds the time to the
  // run's. False if interrupted.
  bool play(const Scene& scene, int advances, const std::atomic<bool>& interrupted, MethodRun& run,
            const std::function<bool(const std::optional<std::string>&)>& look);
  void count(MethodRun& run) const;

  const Problem& problem_;
  StudyMethod method_;
  const Trajectory& accurate_;
  std::unique_ptr<Playback> playback_;
};

}  // namespace hair

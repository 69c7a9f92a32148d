// Runs methods on a problem, and measures their distance from the accurate motion and their cost. A method's
// steps go from a coarse one, each half of the one before, until finer steps tell nothing new. The choice
// depends only on counts and errors, never on times, so a study has the same runs on every machine.
#pragma once

#include <atomic>
#include <functional>

#include "hair/lab/study/study.h"

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

struct StudySettings {
  // The limit of one run: (evaluations of forces + iterations of ConjGrad) times particles. Each unit takes
  // about a tenth of a microsecond.
  double most_work = 1e7;
  Repeats repeats;

  // Called before each run with its description: "RK4, 1024 steps a moment".
  std::function<void(const std::string&)> progress = {};
};

// A study without runs.
Study prepare_study(const Problem& problem, const std::vector<StudyMethod>& methods,
                    const StudySettings& settings, AccurateMotion reference);

// Makes all missing runs, the coarse steps of all methods first, and keeps the runs that the study has.
// Returns false if interrupted: the study then has the finished runs. Marks methods whose exercise is not
// written.
bool finish_study(const Problem& problem, const StudySettings& settings, Study& study,
                  const std::atomic<bool>& interrupted);

// The next number of steps for a method after these runs; nothing if the sweep is at its end: `sweep.end` has
// the reason.
std::optional<int> next_steps(Sweep& sweep, const Errors& floors, int first, double most_work, int particles);

}  // namespace hair

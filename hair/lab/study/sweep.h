// Chooses the steps of a method: from a coarse one, each half of the one before, until finer steps tell
// nothing new. The choice depends only on counts and errors, never on times, so a study has the same runs on
// every machine.
#pragma once

#include <atomic>
#include <functional>

#include "hair/lab/study/method_runner.h"
#include "hair/lab/study/study.h"

namespace hair {

struct StudySettings {
  // The limit of one run: (evaluations of forces + iterations of ConjGrad) times particles. Each unit takes
  // about a tenth of a microsecond.
  double most_work = 1e7;
  Repeats repeats;

  // Called before each run with its description: "RK4, 1024 steps a moment".
  std::function<void(const std::string&)> progress = {};
};

// A study that has neither runs nor a reference yet.
Study prepare_study(const Problem& problem, const std::vector<StudyMethod>& methods,
                    const StudySettings& settings);

// Sets `motion` as the study's reference.
void set_reference(const Problem& problem, const AccurateMotion& motion, Study& study);

// Makes all missing runs, the coarse steps of all methods first, and keeps the runs that the study has.
// Returns false if interrupted: the study then has the finished runs. Marks methods whose exercise is not
// written.
bool finish_study(const Problem& problem, const AccurateMotion& motion, const StudySettings& settings,
                  Study& study, const std::atomic<bool>& interrupted);

// The coarsest step of an explicit method, as steps for each moment: a power of two. With stiff springs no
// method is stable with it.
int coarsest_steps(const Problem& problem, const StudyMethod& method);

// The next number of steps for a method after these runs; nothing if the sweep is at its end: `sweep.end` has
// the reason.
std::optional<int> next_steps(Sweep& sweep, const Errors& floors, int first, double most_work, int particles);

}  // namespace hair

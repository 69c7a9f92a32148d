// Which steps a method is run with: from a coarse one on each half of the one before, until nothing is left
// to learn. What comes next depends on what was counted and on errors alone, never on times: on every
// machine, interrupted or not, a study has the same runs.
#pragma once

#include <atomic>
#include <functional>

#include "hair/lab/study/method_runner.h"
#include "hair/lab/study/study.h"

namespace hair {

struct StudySettings {
  // Of one run: evaluations of forces and iterations of ConjGrad, times the particles. About a tenth of a
  // microsecond each.
  double most_work = 1e7;
  Repeats repeats;

  // Is told before each run what it is: "RK4, 1024 steps a moment".
  std::function<void(const std::string&)> progress = {};
};

// A study without runs, and without a reference yet.
Study prepare_study(const Problem& problem, const std::vector<StudyMethod>& methods,
                    const StudySettings& settings);

// Makes `motion` its reference.
void set_reference(const Problem& problem, const AccurateMotion& motion, Study& study);

// All runs that are still missing, coarse steps of all methods first: those that the study has are kept.
// False if interrupted: the study has what is finished. Of a method whose exercise is not written it says so.
bool finish_study(const Problem& problem, const AccurateMotion& motion, const StudySettings& settings,
                  Study& study, const std::atomic<bool>& interrupted);

// The coarsest step of an explicit method, as steps for each moment: a power of two, within which no method
// is stable where springs are stiff.
int coarsest_steps(const Problem& problem, const StudyMethod& method);

// What is next for a method that had these runs: nothing if `sweep.end` says why.
std::optional<int> next_steps(Sweep& sweep, const Errors& floors, int first, double most_work, int particles);

}  // namespace hair

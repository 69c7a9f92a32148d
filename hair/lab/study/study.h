// A study as plain data: the errors of methods against a problem's accurate motion, for several steps each,
// and their cost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hair/io/machine.h"
#include "hair/lab/study/errors.h"
#include "hair/lab/study/study_methods.h"
#include "hair/truth/accurate_motion.h"
#include "hair/truth/space_error.h"

namespace hair {

enum class RunEnding {
  finished,
  broke,   // a number that is not finite, or impossible for hair
  useless  // a particle was off by more than the strand's length: the run stopped there
};

// The cost of a run, the same on every machine.
struct Counts {
  long steps = 0;
  long evaluations = 0;  // force evaluations that the method's contract specifies
  long iterations = 0;   // ConjGrad's: each is a product with a matrix
  long corrections = 0;  // Newton steps: of H6's length correction, or of implicit Euler to convergence
  long unconverged = 0;  // solves and corrections that ended above their tolerance

  long work() const { return evaluations + iterations; }
};

struct MethodRun {
  int steps_per_moment = 0;
  double step = 0;  // s
  RunEnding ending = RunEnding::finished;
  std::string trouble;  // if it did not finish, where and how: "strand 0, step 17: integration"
  Counts counts;
  Errors errors;                // for a finished run; 0 if below the study's floors
  std::vector<double> seconds;  // CPU time of each repeat

  double time() const;  // their median, s
};

// Why a method gets no finer steps.
enum class SweepEnd {
  unfinished,  // there is more to do
  floor,       // its errors are below the reference's accuracy
  stalls,      // smaller steps make no difference
  budget,      // the next run would cost more than a study allows
  not_written  // an exercise is a stub
};

struct Sweep {
  StudyMethod method;
  std::vector<MethodRun> runs;  // coarse to fine
  SweepEnd end = SweepEnd::unfinished;
  std::string left_out;  // the exercise that is not written
};

struct Study {
  std::string scene, shows;
  std::string content;  // the problem's content_of
  bool quick = false;
  double duration = 0;  // s
  int strand = 0, particles = 0;
  double size = 0;       // m, from size_of
  double tolerance = 0;  // relative, for implicit solves
  double most_work = 0;  // the limit for a run: StudySettings
  Machine machine;

  AccurateMotion reference;  // at the problem's moments
  Errors floors;

  std::vector<Sweep> sweeps;

  // The error that remains for any time step. None until it is known.
  std::optional<SpaceError> space_error;
};

}  // namespace hair

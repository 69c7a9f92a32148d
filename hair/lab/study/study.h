// A study as plain data: how far methods are from a problem's accurate motion, with each of their steps, and
// what that takes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hair/io/machine.h"
#include "hair/lab/study/errors.h"
#include "hair/lab/study/study_methods.h"
#include "hair/truth/space_error.h"

namespace hair {

enum class RunEnding {
  finished,
  broke,   // a number that is not finite, or that no hair has
  useless  // a particle farther off than the whole strand is long: ended there
};

// What a run took, the same on every machine.
struct Counts {
  long steps = 0;
  long evaluations = 0;  // of the forces, as many as the method's contract says
  long iterations = 0;   // of ConjGrad: each a product with a matrix
  long corrections = 0;  // Newton steps: of H6's length correction, or of implicit Euler to convergence
  long unconverged = 0;  // solves and corrections that ended above their tolerance

  long work() const { return evaluations + iterations; }
};

struct MethodRun {
  int steps_per_moment = 0;
  double step = 0;  // s
  RunEnding ending = RunEnding::finished;
  std::string trouble;  // where it ended before its end, and how: "strand 0, step 17: integration"
  Counts counts;
  Errors errors;                // of one that finished; below the study's floors: 0
  std::vector<double> seconds;  // CPU time of each repeat

  double time() const;  // their median, s
};

// Why a method has no finer steps.
enum class SweepEnd {
  unfinished,  // there is more to do
  floor,       // its errors are below what the reference knows
  stalls,      // smaller steps make no difference
  budget,      // the next run would take more than a study allows
  not_written  // an exercise is a stub
};

struct Sweep {
  StudyMethod method;
  std::vector<MethodRun> runs;  // coarse to fine
  SweepEnd end = SweepEnd::unfinished;
  std::string left_out;  // what is not written
};

struct Study {
  std::string scene, shows;
  std::string content;  // of the problem: content_of
  bool quick = false;
  double duration = 0;  // s
  int strand = 0, particles = 0;
  double size = 0;       // m: size_of
  double tolerance = 0;  // of implicit solves
  double most_work = 0;  // of a run: StudySettings
  Machine machine;
  std::string program_digest;  // of whoever wants to resume it: program_digest()

  // The accurate motion.
  std::string reference;
  double agreement = 0, least_error = 0;  // m
  bool inextensible = false, from_cache = false;
  double reference_seconds = 0;
  Errors floors;

  std::vector<Sweep> sweeps;

  // What is wrong however small the step. None before it is known.
  std::optional<SpaceError> space_error;
};

}  // namespace hair

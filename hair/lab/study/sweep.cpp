#include "hair/lab/study/sweep.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/plot/work_precision.h"
#include "solver/not_implemented.h"

namespace hair {

namespace {

constexpr int kMostSteps = 1 << 24;

// An upper bound of the squares of the angular frequencies with which springs swing, 1/s^2: twice the largest
// sum of the stiffnesses at a particle, over its mass (Gershgorin).
double fastest_squared(const Problem& problem) {
  const Eigen::VectorXd& mass =
      problem.is_toy() ? problem.scene.toys[0].particles.mass : problem.scene.hair.strands[0].strand.mass;
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(mass.size());
  if (problem.is_toy()) {
    for (const particles::Spring& spring : problem.scene.toys[0].springs)
      for (const int i : {spring.i, spring.j}) sums[i] += spring.stiffness;
  } else {
    const Strand& strand = problem.scene.hair.strands[0].strand;
    const Eigen::VectorXd stiffness = strand.stretch_rigidity * strand.rest_length.cwiseInverse();
    sums.head(stiffness.size()) += stiffness;
    sums.tail(stiffness.size()) += stiffness;
  }
  return 2 * sums.cwiseQuotient(mass).maxCoeff();
}

bool is_below(const MethodRun& run, const Errors& floors) {
  return run.ending == RunEnding::finished && run.errors[Norm::final_largest] < floors[Norm::final_largest] &&
         run.errors[Norm::trajectory] < floors[Norm::trajectory];
}

// True if the last halvings of the step made no difference. Errors below the floors are unknown.
bool stalls(const std::vector<MethodRun>& runs, const Errors& floors) {
  std::vector<double> errors;
  for (const MethodRun& run : runs) {
    const double error = run.errors[Norm::trajectory];
    const bool known = run.ending == RunEnding::finished && error >= floors[Norm::trajectory];
    errors.push_back(known ? error : std::nan(""));
  }
  return hair::stalls(errors);
}

// The work of the whole next run, if it takes twice as many steps.
double work_of_next(const MethodRun& run, int particles) {
  const double of_a_step = static_cast<double>(std::max(1L, run.counts.work())) /
                           static_cast<double>(std::max(1L, run.counts.steps));
  return 2 * of_a_step * run.steps_per_moment * kMoments * particles;
}

// Throws BadInput for a problem that can't be assembled.
std::unique_ptr<MethodRunner> make_runner(const Problem& problem, const StudyMethod& method,
                                          const Trajectory& accurate, const Errors& floors) {
  try {
    return std::make_unique<MethodRunner>(problem, method, accurate, floors);
  } catch (const std::invalid_argument& error) {
    throw BadInput(problem.scene.name + ": " + error.what());
  }
}

}  // namespace

int coarsest_steps(const Problem& problem, const StudyMethod& method) {
  if (!method.is_explicit()) return 1;
  // The largest limit of P1's methods is Runge and Kutta's, 2.83 / omega.
  constexpr double kFar = 2;  // times beyond
  const double limit = 2.83 / std::sqrt(std::max(fastest_squared(problem), 1e-12));
  const double moment = problem.duration / kMoments;
  int steps = 1;
  while (steps < kMostSteps && moment / steps > kFar * limit) steps *= 2;
  return steps;
}

std::optional<int> next_steps(Sweep& sweep, const Errors& floors, int first, double most_work,
                              int particles) {
  sweep.end = SweepEnd::unfinished;
  if (!sweep.left_out.empty()) {
    sweep.end = SweepEnd::not_written;
  } else if (sweep.runs.empty()) {
    return first;
  } else if (is_below(sweep.runs.back(), floors)) {
    sweep.end = SweepEnd::floor;
  } else if (stalls(sweep.runs, floors)) {
    sweep.end = SweepEnd::stalls;
  } else if (work_of_next(sweep.runs.back(), particles) > most_work ||
             sweep.runs.back().steps_per_moment >= kMostSteps) {
    sweep.end = SweepEnd::budget;
  }
  if (sweep.end != SweepEnd::unfinished) return {};
  return 2 * sweep.runs.back().steps_per_moment;
}

Study prepare_study(const Problem& problem, const std::vector<StudyMethod>& methods,
                    const StudySettings& settings) {
  Study study;
  study.scene = problem.scene.name;
  study.shows = problem.scene.shows;
  study.duration = problem.duration;
  study.size = size_of(problem);
  study.content = content_of(problem);
  study.tolerance = problem.scene.hair.tolerance;
  study.most_work = settings.most_work;
  study.machine = this_machine();
  for (const StudyMethod& method : methods) study.sweeps.emplace_back().method = method;
  return study;
}

void set_reference(const Problem& problem, const AccurateMotion& motion, Study& study) {
  study.particles = points_of(problem);
  study.reference = motion.method;
  study.agreement = motion.agreement;
  study.least_error = motion.least_error();
  study.inextensible = motion.inextensible;
  study.from_cache = motion.from_cache;
  study.reference_seconds = motion.cpu_seconds;
  study.floors = floors(problem, study.least_error);
}

bool finish_study(const Problem& problem, const AccurateMotion& motion, const StudySettings& settings,
                  Study& study, const std::atomic<bool>& interrupted) {
  std::vector<std::unique_ptr<MethodRunner>> runners(study.sweeps.size());
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < study.sweeps.size(); ++i) {
      Sweep& sweep = study.sweeps[i];
      const std::optional<int> steps = next_steps(sweep, study.floors, coarsest_steps(problem, sweep.method),
                                                  study.most_work, study.particles);
      if (!steps) continue;
      if (settings.progress)
        settings.progress(sweep.method.name + ", " + std::to_string(*steps) + " steps a moment");
      try {
        if (!runners[i]) runners[i] = make_runner(problem, sweep.method, motion.states, study.floors);
        std::optional<MethodRun> run = runners[i]->run(*steps, settings.repeats, interrupted);
        if (!run) return false;
        sweep.runs.push_back(std::move(*run));
      } catch (const NotImplemented& stub) {
        sweep.left_out = printable(stub.what());
      }
      more = true;
    }
  }
  return true;
}

}  // namespace hair

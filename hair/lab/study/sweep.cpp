#include "hair/lab/study/sweep.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/plot/page.h"
#include "hair/io/plot/work_precision.h"
#include "solver/not_implemented.h"
#include "solver/timing.h"

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

// The coarsest step of an explicit method, as steps for each moment: a power of two. With stiff springs no
// method is stable with it.
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

constexpr int kMostTimes = 1000;  // between two looks at the clock

bool once_more(const std::vector<double>& seconds, const Repeats& repeats) {
  const int times = static_cast<int>(seconds.size());
  const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  if (times < repeats.least) return sum < repeats.too_long;
  return times < repeats.most && sum < repeats.enough;
}

class MethodRunner {
 public:
  // Assembles the problem with the method, once for all steps. Keeps references to the problem and the study.
  // Throws std::invalid_argument if the problem can't be assembled.
  MethodRunner(const Problem& problem, const StudyMethod& method, const Study& study)
      : problem_(problem), method_(method), study_(study), scene_run_(with_method(problem, method, 1)) {}

  // Empty if interrupted. Passes on exceptions of stubs; any other exception of an exercise counts as a
  // failed run. Times include only the steps, not the measurements. Errors below the floors are set to 0.
  std::optional<MethodRun> run(int steps_per_moment, const Repeats& repeats,
                               const std::atomic<bool>& interrupted) {
    const Scene scene = with_method(problem_, method_, steps_per_moment);
    MethodRun run;
    run.steps_per_moment = steps_per_moment;
    run.step = scene.hair.step;
    try {
      if (!compare(scene, interrupted, run)) return {};
      count(run);
      if (!repeat(scene, repeats, interrupted, run)) return {};
    } catch (const NotImplemented&) {
      throw;
    } catch (const std::exception& error) {
      run.ending = RunEnding::broke;
      run.trouble = "step " + std::to_string(scene_run_.steps()) + ": threw " + printable(error.what());
      run.errors = {};
      count(run);
    }
    return run;
  }

 private:
  // Runs once and records errors and time, or the reason why it did not reach its end. All return false if
  // interrupted.
  bool compare(const Scene& scene, const std::atomic<bool>& interrupted, MethodRun& run) {
    const double useless = study_.size;
    ErrorTally tally(problem_, study_.reference.states);
    scene_run_.restart(scene);
    tally.add(scene_run_);
    run.seconds = {0};
    while (scene_run_.frame() < scene.frames) {
      if (interrupted) return false;
      const double start = timing::cpu_seconds();
      const std::optional<std::string> trouble = scene_run_.advance();
      run.seconds[0] += timing::cpu_seconds() - start;
      if (trouble) {
        run.ending = RunEnding::broke;
        run.trouble = *trouble;
        return true;
      }
      const double off = tally.add(scene_run_);
      if (!(off <= useless)) {
        run.ending = RunEnding::useless;
        run.trouble = to_text(off) + " m off after " + to_text(scene_run_.time()) + " s";
        return true;
      }
    }
    run.errors = tally.errors();
    for (const Norm norm : all_norms())
      if (run.errors[norm] < study_.floors[norm]) run.errors[norm] = 0;
    return true;
  }

  // Runs from the start, `times` times, `advances` moments each: the total CPU time, s.
  std::optional<double> play(const Scene& scene, int times, int advances,
                             const std::atomic<bool>& interrupted) {
    const double start = timing::cpu_seconds();
    for (int i = 0; i < times; ++i) {
      scene_run_.restart(scene);
      for (int k = 0; k < advances; ++k) {
        if (interrupted) return {};
        scene_run_.advance();
      }
    }
    return timing::cpu_seconds() - start;
  }

  bool repeat(const Scene& scene, const Repeats& repeats, const std::atomic<bool>& interrupted,
              MethodRun& run) {
    // A run that broke or became useless did so on the way to its next moment, or at it.
    const int advances = scene_run_.frame() + (run.ending == RunEnding::broke ? 1 : 0);
    const double once = run.seconds[0];
    const int times = std::clamp(static_cast<int>(repeats.clock / std::max(once, 1e-9)), 1, kMostTimes);
    std::vector<double> seconds;
    if (once >= repeats.warm) seconds.push_back(once);
    while (once_more(seconds, repeats)) {
      const auto all = play(scene, times, advances, interrupted);
      const auto restarts = play(scene, times, 0, interrupted);
      if (!all || !restarts) return false;
      seconds.push_back(std::max(0.0, *all - *restarts) / times);
    }
    run.seconds = seconds;
    return true;
  }

  void count(MethodRun& run) const {
    const Work work = scene_run_.work();
    const long steps = scene_run_.steps();
    run.counts = {steps, steps * row_of(method_.method).evaluations, work.solver_steps, work.correction_steps,
                  work.unconverged};
  }

  const Problem& problem_;
  StudyMethod method_;
  const Study& study_;
  SceneRun scene_run_;
};

}  // namespace

double MethodRun::time() const {
  return timing::median(seconds);
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
                    const StudySettings& settings, AccurateMotion reference) {
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
  study.particles = static_cast<int>(reference.states.front().x.size() / 3);
  study.floors = floors(problem, reference.least_error());
  study.reference = std::move(reference);
  return study;
}

bool finish_study(const Problem& problem, const StudySettings& settings, Study& study,
                  const std::atomic<bool>& interrupted) {
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
        if (!runners[i]) runners[i] = std::make_unique<MethodRunner>(problem, sweep.method, study);
        std::optional<MethodRun> run = runners[i]->run(*steps, settings.repeats, interrupted);
        if (!run) return false;
        sweep.runs.push_back(std::move(*run));
      } catch (const NotImplemented& stub) {
        sweep.left_out = printable(stub.what());
      } catch (const std::invalid_argument& error) {
        throw BadInput(problem.scene.name + ": " + error.what());
      }
      more = true;
    }
  }
  return true;
}

}  // namespace hair

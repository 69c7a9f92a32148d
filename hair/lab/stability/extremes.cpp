#include "hair/lab/stability/extremes.h"

#include <algorithm>
#include <cmath>

#include "hair/lab/stability/maps.h"
#include "hair/lab/stability/theory.h"
#include "hair/strand/measures.h"
#include "particles/system.h"

namespace hair {

namespace {

constexpr double kStepsOfAll[] = {1.0 / 60, 1.0 / 240};

// The hair at rest lengths times `stretch`, straight along a direction, or folded back and forth along it.
void lay(StrandStart& start, const Vector3d& direction, double stretch, bool folded) {
  for (int i = 1; i < start.strand.count(); ++i) {
    const double way = (folded && i % 2 == 0 ? -1 : 1) * stretch * start.strand.rest_length[i - 1];
    start.state.x.segment<3>(3 * i) = start.state.x.segment<3>(3 * i - 3) + way * direction;
  }
}

// J, relative to the root's own motion.
double energy_of(const Simulation& simulation) {
  const particles::State& state = simulation.state(0);
  Eigen::VectorXd v = state.v;
  for (Eigen::Index i = 0; i < v.size(); i += 3) v.segment<3>(i) -= Vector3d(state.v.head<3>());
  return particles::kinetic_energy(simulation.particles(0), v) + simulation.force(0).energy(state.x);
}

double energy_at_rest(const Description& hair) {
  const Hanging hanging = hang(hair, 1, false);
  Description resting = hair;
  resting.strands = {hanging.start};
  return energy_of(Simulation(std::move(resting)));
}

ExtremeRun run_extreme(const Description& description, double at_rest, long steps) {
  ExtremeRun run;
  run.h = description.step;
  Simulation simulation(description);
  const double given = energy_of(simulation) - at_rest;
  while (simulation.steps() < steps) {
    if (const auto blow_up = simulation.step()) {
      run.blow_up = "step " + std::to_string(blow_up->step) + ": " + stage_name(blow_up->stage);
      break;
    }
    run.last_stretch = largest_stretch(simulation.strand(0), simulation.state(0).x);
    run.stretch = std::max(run.stretch, run.last_stretch);
    run.last_energy = (energy_of(simulation) - at_rest) / given;
    run.most_energy = std::max(run.most_energy, run.last_energy);
  }
  const bool blown = !run.blow_up.empty() || !(run.last_energy <= kBlownEnergy);
  run.steps = simulation.steps();
  run.fate = blown                            ? Fate::blown_up
             : run.most_energy > kWrongEnergy ? Fate::wrong
             : run.last_energy < kLostEnergy  ? Fate::damped_out
                                              : Fate::stable;
  return run;
}

}  // namespace

std::vector<ExtremeCase> extreme_cases(const Description& hair) {
  const Hanging hanging = hang(hair, 1, true);
  StrandStart level = hanging.start;
  level.state.v.setZero();
  level.strand.root_tangent = hanging.across;
  lay(level, hanging.across, 1, false);
  std::vector<ExtremeCase> cases;
  const auto add = [&](const char* name, const StrandStart& start) -> StrandStart& {
    cases.push_back({name, start});
    return cases.back().start;
  };
  const bool falls = hair.gravity != Vector3d::Zero();
  if (falls) add("held level", level);
  lay(add("folded", level), hanging.across, 1, true);
  lay(add("crushed to a hundredth", hanging.start), hanging.down, 0.01, false);
  lay(add("torn to thrice its length", hanging.start), hanging.down, 3, false);
  add("its root flung at 30 m/s", hanging.start).state.v.head<3>() = 30 * hanging.across;
  if (!falls) return cases;
  StrandStart& heavy = add("a tip of 1e6 times its mass", level);
  heavy.strand.mass[heavy.strand.count() - 1] *= 1e6;
  add("EA 1e4 times as large", level).strand.stretch_rigidity *= 1e4;
  add("EA 1e6 times as large", level).strand.stretch_rigidity *= 1e6;
  return cases;
}

std::vector<ExtremeRun> run_extremes(const Description& hair, const StudyMethod& method,
                                     const std::atomic<bool>& interrupted) {
  Description description = with_options(hair, method);
  description.drag = 0;
  description.wind.setZero();
  description.obstacles.clear();
  std::vector<ExtremeRun> runs;
  for (const ExtremeCase& extreme : extreme_cases(description)) {
    description.strands = {extreme.start};
    const double at_rest = energy_at_rest(description);
    const auto add = [&](double h, const std::string& step_from) {
      description.step = h;
      const long steps = std::min(std::lround(kExtremeDuration / h), kMostExtremeSteps);
      runs.push_back(run_extreme(description, at_rest, steps));
      runs.back().extreme = extreme.name;
      runs.back().method = method;
      runs.back().step_from = step_from;
    };
    for (const double h : kStepsOfAll) {
      if (interrupted) return {};
      add(h, {});
    }
    if (method.is_explicit()) {
      // If a method has no limit without drag, it gets half of RK4's, the largest of all.
      const Oscillator fastest{hang(description, 1, false).fastest()};
      const double limit = explicit_limit(method.method, fastest);
      if (limit > 0)
        add(limit / 2, "half its limit");
      else
        add(explicit_limit(Method::runge_kutta_4, fastest) / 2, "half of RK4's limit");
    }
  }
  return runs;
}

}  // namespace hair

// Measures the cost of a step of hair, by method and number of strands, and by stiffness.
//
// All hair is human hair in segments of 1 cm that starts level and swings down for `kWarmUp` steps before it
// is timed, so that it is bent and moves.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hair/simulation/simulation.h"
#include "hair/strand/make_strand.h"
#include "hair/strand/measures.h"
#include "hair/strand/rest_shape.h"
#include "solver/timing.h"

namespace hair_bench {
namespace {

using Eigen::Vector3d;
using hair::Description;
using hair::Method;
using hair::Simulation;

constexpr double kStep = 1.0 / 240;
constexpr int kWarmUp = 20;

hair::StrandStart level_hair(int segments, const hair::Material& material = {}) {
  const Eigen::VectorXd x = hair::straight_shape(segments, 0.01 * segments,
                                                 {Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY()})
                                .x;
  return {hair::strand_from_rest(material, x), {x, Eigen::VectorXd::Zero(x.size())}};
}

Simulation swinging(Method method, int strands, int segments, double step,
                    const hair::Material& material = {}) {
  Description description;
  description.method = method;
  description.step = step;
  description.strands.assign(strands, level_hair(segments, material));
  Simulation simulation(std::move(description));
  simulation.advance(kWarmUp);
  return simulation;
}

// Arguments: number of strands, of 16 particles each.
void steps(benchmark::State& state, Method method) {
  constexpr int kParticles = 16;
  const int strands = static_cast<int>(state.range(0));
  Simulation simulation = swinging(method, strands, kParticles - 1, kStep);
  const long solver_steps = simulation.work().solver_steps;
  long taken = 0;
  double fastest = INFINITY;
  for (auto _ : state) {
    const double start = timing::cpu_seconds();
    simulation.step();
    const double time = timing::cpu_seconds() - start;
    fastest = std::min(fastest, time);
    state.SetIterationTime(time);
    ++taken;
  }
  const double particle_steps = static_cast<double>(kParticles) * strands;
  state.counters["ns"] = fastest * 1e9 / particle_steps;
  state.counters["CG"] = static_cast<double>(simulation.work().solver_steps - solver_steps) /
                         static_cast<double>(taken * strands);
}
BENCHMARK_CAPTURE(steps, H4, Method::implicit_euler)->Arg(1)->Iterations(400)->UseManualTime();
BENCHMARK_CAPTURE(steps, H4, Method::implicit_euler)->Arg(100)->Iterations(20)->UseManualTime();
BENCHMARK_CAPTURE(steps, H4, Method::implicit_euler)->Arg(10'000)->Iterations(3)->UseManualTime();
BENCHMARK_CAPTURE(steps, H6, Method::predictor_corrector)->Arg(1)->Iterations(400)->UseManualTime();
BENCHMARK_CAPTURE(steps, H6, Method::predictor_corrector)->Arg(100)->Iterations(20)->UseManualTime();
BENCHMARK_CAPTURE(steps, H6, Method::predictor_corrector)->Arg(10'000)->Iterations(3)->UseManualTime();

// Iterations of ConjGrad for a solve, 30 segments. Arguments: the logarithm of how many times hair's
// stiffness.
void stiffness(benchmark::State& state, Method method) {
  hair::Material material;
  material.young_modulus *= std::pow(10, static_cast<double>(state.range(0)));
  Simulation simulation = swinging(method, 1, 30, kStep, material);
  const hair::Work before = simulation.work();
  for (auto _ : state) simulation.step();
  const double solves = static_cast<double>(simulation.work().strand_steps - before.strand_steps) *
                        (method == Method::implicit_euler ? 1 : 2);
  state.counters["CG"] = static_cast<double>(simulation.work().solver_steps - before.solver_steps) / solves;
  state.counters["unconverged_%"] =
      100 * static_cast<double>(simulation.work().unconverged - before.unconverged) / solves;
  state.counters["stretch"] = hair::largest_stretch(simulation.strand(0), simulation.state(0).x);
}
BENCHMARK_CAPTURE(stiffness, H4, Method::implicit_euler)
    ->DenseRange(-4, 6, 2)
    ->Iterations(40)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(stiffness, H6, Method::predictor_corrector)
    ->DenseRange(-4, 6, 2)
    ->Iterations(40)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hair_bench

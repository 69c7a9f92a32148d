// What dense hair costs: strands synthesised in a second, beside what memcpy moves of the same bytes in the same run.
//
// 150,000 strands of 16 points between 500 guides on a half of a head, as floats: 28.8 MB, far more than caches hold. The
// counters: strands a second; `of memcpy`, the time of a copy of these bytes over the time of making them.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>

#include "hair/head/synthesis.h"
#include "solver/timing.h"

namespace hair_bench {
namespace {

using hair::RootFrame, hair::Synthesis, hair::SynthesisMode, hair::Vector3d;

constexpr int kGuides = 500, kStrands = 150'000, kPoints = 16;

std::vector<RootFrame> roots_on_head(int count) {
  std::vector<RootFrame> roots;
  for (int i = 0; i < count; ++i) {
    const double height = 1 - (i + 0.5) / count, across = std::sqrt(1 - height * height), angle = 2.4 * i;
    const Vector3d normal(across * std::cos(angle), across * std::sin(angle), height);
    roots.push_back({0.1 * normal, normal.normalized(), hair::side_of(normal.normalized())});
  }
  return roots;
}

// Waves that bend down.
std::vector<double> guides_on(const std::vector<RootFrame>& roots) {
  std::vector<double> points;
  for (const RootFrame& root : roots)
    for (int i = 0; i < kPoints; ++i) {
      const double s = 0.01 * i;
      const Vector3d point = root.position + s * root.axis - 3 * s * s * Vector3d::UnitZ() +
                             0.003 * std::sin(100 * s) * root.side;
      points.insert(points.end(), point.begin(), point.end());
    }
  return points;
}

void synthesis(benchmark::State& state, SynthesisMode mode) {
  const std::vector<RootFrame> roots = roots_on_head(kGuides);
  const std::vector<double> guides = guides_on(roots);
  Synthesis hair({.guides = roots,
                  .children = roots_on_head(kStrands),
                  .points = kPoints,
                  .mode = mode,
                  .spread = 1.5,
                  .jitter = 0.2,
                  .length = 0.1},
                 static_cast<int>(state.range(0)));
  std::vector<float> strands(3 * static_cast<std::size_t>(kPoints) * kStrands, 1), copy(strands.size(), 2);
  double making = 0, copying = 0;
  for (auto _ : state) {
    double now = 0;
    {
      const timing::AddsTime watch(now);
      hair.make(guides, Eigen::Matrix3d::Identity(), {}, std::span<float>(strands));
    }
    making += now;
    state.SetIterationTime(now);
    const timing::AddsTime watch(copying);
    std::memcpy(copy.data(), strands.data(), strands.size() * sizeof(float));
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
  state.counters["strands/s"] = kStrands * static_cast<double>(state.iterations()) / making;
  state.counters["of memcpy"] = copying / making;
  state.counters["memcpy GB/s"] = static_cast<double>(strands.size() * sizeof(float)) *
                                  static_cast<double>(state.iterations()) / copying / 1e9;
}
BENCHMARK_CAPTURE(synthesis, interpolate, SynthesisMode::interpolate)
    ->Arg(1)
    ->Arg(2)
    ->Iterations(20)
    ->UseManualTime();
BENCHMARK_CAPTURE(synthesis, extrapolate, SynthesisMode::extrapolate)
    ->Arg(1)
    ->Arg(2)
    ->Iterations(20)
    ->UseManualTime();
BENCHMARK_CAPTURE(synthesis, blend, SynthesisMode::blend)->Arg(1)->Arg(2)->Iterations(20)->UseManualTime();

}  // namespace
}  // namespace hair_bench

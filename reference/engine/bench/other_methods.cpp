// STAFF ONLY. The engine beside other methods, on the same strands in the same run.
#include <algorithm>
#include <cstdio>
#include <string>

#include "hair/bench/bullet_rope.h"
#include "hair/strand/measures.h"
#include "reference/engine/bench/bench_head.h"
#include "reference/engine/bench/plain_xpbd.h"
#include "reference/engine/bench/tables.h"
#include "reference/engine/head_of_strands.h"

namespace hair_bench {

using Eigen::VectorXd;
using hair::FullHead, hair::FullHeadSettings, hair::Vector3d;

// A level strand without bending that swings, as in hair_bench's beside_bullet.
void beside_others() {
  constexpr double h = 1.0 / 240, l0 = 0.01;
  constexpr int kTurns = 120, kHairs = 800;
  std::printf("\n| a swing of half a second, h = 1/240 s | ns | largest stretch |\n|---|--:|--:|\n");
  FullHeadSettings settings = with(false, false, false);
  settings.drag = 0;
  const auto start = hair::engine::given_strand(settings, kPoints, l0, Vector3d::UnitX());
  const hair::Strand& strand = start->strand;
  const auto report = [&](const std::string& name, int hairs, const std::function<void()>& step,
                          const std::function<VectorXd()>& x) {
    double time = 0, stretch = 0;
    for (int k = 0; k < kTurns; ++k) {
      time += least(1, step);
      stretch = std::max(stretch, hair::largest_stretch(strand, x()));
    }
    std::printf("| %s | %.1f | %.1e |\n", name.c_str(), 1e9 * time / kTurns / hairs / kPoints, stretch);
    std::fflush(stdout);
    return stretch;
  };
  double stretch = 0;
  for (const bool correction : {false, true}) {
    settings.correct_lengths = correction;
    FullHead head(std::vector<int>(kHairs, kPoints), settings);
    for (int k = 0; k < kHairs; ++k)
      head.set_strand(k, l0, Vector3d::UnitX(), start->state.x, start->state.v);
    const auto x = [&] {
      VectorXd places(3 * kPoints), rates(3 * kPoints);
      head.get_strand(0, places, rates);
      return places;
    };
    const double reached = report(
        correction ? "the engine, with correction" : "the engine", kHairs, [&] { head.step(h); }, x);
    if (!correction) stretch = reached;
  }
  for (const int iterations : {10, 100}) {
    BulletRope rope(strand, iterations);
    report(
        "Bullet's rope, " + std::to_string(iterations) + " iterations", 1, [&] { rope.step(h); },
        [&] { return rope.positions(); });
  }
  for (int iterations = 10; iterations <= 1'000'000; iterations *= 10) {
    PlainXpbd rope(strand, start->state.x, iterations);
    const double reached = report(
        "plain XPBD, " + std::to_string(iterations) + " iterations", 1, [&] { rope.step(h); },
        [&] { return rope.positions(); });
    if (reached <= stretch) break;
  }
}

}  // namespace hair_bench

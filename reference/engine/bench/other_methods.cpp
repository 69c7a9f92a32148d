// STAFF ONLY. The engine beside other methods, on the same strands in the same run.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
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

namespace {

constexpr double kSwingStep = 1.0 / 240, kSegment = 0.01;
constexpr int kTurns = 120, kFirstIterations = 10, kMostIterations = 10'240;

struct Swing {
  double ns, stretch;  // per particle and step; the largest on the way
};

Swing swing(const hair::Strand& strand, int hairs, const std::function<void()>& step,
            const std::function<VectorXd()>& x) {
  double time = 0, stretch = 0;
  for (int k = 0; k < kTurns; ++k) {
    time += least(1, step);
    stretch = std::max(stretch, hair::largest_stretch(strand, x()));
  }
  return {1e9 * time / kTurns / hairs / kPoints, stretch};
}

void print(const std::string& name, const Swing& swing, const std::string& beside) {
  std::printf("| %s | %.1f | %.1e | %s |\n", name.c_str(), swing.ns, swing.stretch, beside.c_str());
  std::fflush(stdout);
}

// A method that iterates takes twice as many iterations again until it stretches no more than the engine; first without correction, then with.
template <typename MakeRope>
void print_at_equal_stretch(const std::string& name, const hair::Strand& strand, const Swing (&engine)[2],
                            const MakeRope& make) {
  int goal = 0;
  for (int iterations = kFirstIterations; goal < 2; iterations *= 2) {
    auto rope = make(iterations);
    const Swing found = swing(
        strand, 1, [&] { rope.step(kSwingStep); }, [&] { return VectorXd(rope.positions()); });
    const std::string row = name + ", " + std::to_string(iterations) + " iterations";
    const auto times = [&](int k) { return std::to_string(std::lround(found.ns / engine[k].ns)); };
    const bool equal = found.stretch <= engine[goal].stretch, last = 2 * iterations > kMostIterations;
    if (equal)
      print(row, found,
            "at equal stretch error: " + times(goal) + " times " + (goal ? "with correction" : "the engine"));
    else if (last)
      print(row, found, "still more than with correction, " + times(1) + " times its time");
    else if (iterations == kFirstIterations)
      print(row, found, "");
    if (last) return;
    goal += equal;
  }
}

}  // namespace

// A level strand without bending that swings, as in hair_bench's beside_bullet.
void beside_others() {
  constexpr int kHairs = 800;
  std::printf(
      "\n| a swing of half a second, h = 1/240 s | ns | largest stretch | beside the engine "
      "|\n|---|--:|--:|---|\n");
  FullHeadSettings settings = with(false, false, false);
  settings.drag = 0;
  const auto start = hair::engine::given_strand(settings, kPoints, kSegment, Vector3d::UnitX());
  const hair::Strand& strand = start->strand;
  Swing engine[2];
  for (const bool correction : {false, true}) {
    settings.correct_lengths = correction;
    FullHead head(std::vector<int>(kHairs, kPoints), settings);
    for (int k = 0; k < kHairs; ++k)
      head.set_strand(k, kSegment, Vector3d::UnitX(), start->state.x, start->state.v);
    engine[correction] = swing(
        strand, kHairs, [&] { head.step(kSwingStep); },
        [&] {
          VectorXd places(3 * kPoints), rates(3 * kPoints);
          head.get_strand(0, places, rates);
          return places;
        });
    print(correction ? "the engine, with correction" : "the engine", engine[correction], "");
  }
  print_at_equal_stretch("Bullet's rope", strand, engine,
                         [&](int iterations) { return BulletRope(strand, iterations); });
  print_at_equal_stretch("plain XPBD", strand, engine,
                         [&](int iterations) { return PlainXpbd(strand, start->state.x, iterations); });
}

}  // namespace hair_bench

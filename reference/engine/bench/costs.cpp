// STAFF ONLY. What a step of the engine costs. CPU times, so that other programs on the machine matter less: the least of some steps.
#include <hwy/targets.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "hair/length_correction.h"
#include "hair/predictor_corrector.h"
#include "hair/strand/obstacles.h"
#include "particles/implicit_euler.h"
#include "reference/engine/bench/bench_head.h"
#include "reference/engine/bench/peaks.h"
#include "reference/engine/bench/tables.h"
#include "reference/engine/head_of_strands.h"

namespace hair_bench {

using Eigen::VectorXd;
using hair::FullHeadSettings;

namespace {

// The same by given code: H4, H5 and the collision of obstacles.h with the bust itself.
double given_ns(const FullHeadSettings& settings, const hair::Groom& groom) {
  constexpr int kStrands = 40;
  std::vector<std::unique_ptr<hair::MovingStrand>> strands;
  for (int k = 0; k < kStrands; ++k) {
    const VectorXd& x = groom.strands[k];
    double length = 0;
    for (int i = 1; i < kPoints; ++i) length += (x.segment<3>(3 * i) - x.segment<3>(3 * i - 3)).norm();
    strands.push_back(hair::engine::given_strand(settings, kPoints, length / (kPoints - 1),
                                                 (x.segment<3>(3) - x.head<3>()).normalized()));
    strands.back()->state.x = x;
  }
  std::vector<hair::Obstacle> obstacles;
  if (settings.head) obstacles.push_back({hair::PlacedSolid{settings.head}, settings.friction});
  Eigen::MatrixXd scratch(3 * kPoints, hair::kPredictorCorrectorScratch);
  VectorXd before(3 * kPoints), predicted(3 * kPoints);
  const auto step = [&] {
    for (const auto& one : strands) {
      before = one->state.x;
      implicit_euler(one->force, one->particles, kStep, particles::kSolveTolerance, one->state, scratch);
      if (settings.correct_lengths) {
        predicted = one->state.x;
        correct_lengths(one->strand, hair::kLengthTolerance, hair::kMostCorrections, one->state.x, scratch);
        one->state.v += (one->state.x - predicted) / kStep;
      }
      if (settings.head) collide(obstacles, one->particles, kStep, before, one->state);
    }
  };
  for (int i = 0; i < kWarmUp; ++i) step();
  return 1e9 * least(kSteps, step) / (kStrands * kPoints);
}

// Of the process, until now: bytes; 0 where Linux does not say it.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return 1024 * std::strtod(line.c_str() + 6, nullptr);
  return 0;
}

// For engines made from now on.
void use_sets_without(long long disabled) {
  hwy::DisableTargets(disabled);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

void by_parts(int strands, const hair::Groom& grown) {
  std::printf(
      "| parts, %d strands x %d points, h = 1/24 s | ns | given code, ns | times |\n|---|--:|--:|--:|\n",
      strands, kPoints);
  const struct {
    const char* name;
    FullHeadSettings settings;
  } rows[] = {{"stretch", with(false, false, false)},
              {"stretch, correction", with(false, true, false)},
              {"stretch, bending", with(true, false, false)},
              {"stretch, head", with(false, false, true)},
              {"stretch, correction, head", with(false, true, true)},
              {"stretch, bending, head", with(true, false, true)},
              {"stretch, bending, correction", with(true, true, false)},
              {"everything", with(true, true, true)}};
  for (const auto& [name, settings] : rows) {
    const double ours = engine_ns(settings, strands, grown), given = given_ns(settings, grown);
    std::printf("| %s | %.1f | %.0f | %.0f |\n", name, ours, given, given / ours);
    std::fflush(stdout);
  }
}

void by_strands(const hair::Groom& grown) {
  std::printf("\n| everything, strands | 1,000 | 10,000 | 50,000 | 200,000 |\n|---|--:|--:|--:|--:|\n| ns |");
  std::string memory = "| bytes per particle |";
  for (const int strands : {1'000, 10'000, 50'000, 200'000}) {
    double bytes = 0;
    std::printf(" %.1f |",
                engine_ns(with(true, true, true), strands, grown, timing::process_cpu_seconds, &bytes));
    std::fflush(stdout);
    memory += " " + std::to_string(std::lround(bytes)) + " |";
  }
  // Strands to start from, the bench itself and heads of before are in it.
  std::printf("\n%s\n\nThe process's peak memory with 200,000 strands: %.0f MB, %.0f bytes per particle\n",
              memory.c_str(), 1e-6 * peak_memory(), peak_memory() / (200'000.0 * kPoints));
}

void by_set(int strands, const hair::Groom& grown) {
  std::printf("\n| everything, %d strands | ns |\n|---|--:|\n", strands);
  // With all that Highway has beyond it: better targets have smaller numbers.
  constexpr long long kAvx512 = 2 * HWY_AVX3 - 1;
  const struct {
    const char* name;
    long long disabled;
  } sets[] = {{"AVX-512", 0}, {"AVX2", kAvx512}, {"scalars", ~0LL}};
  const auto here = hwy::SupportedTargets();
  for (const auto& [name, disabled] : sets) {
    if (disabled == 0 && !(here & kAvx512)) continue;
    use_sets_without(disabled);
    std::printf("| %s | %.1f |\n", name, engine_ns(with(true, true, true), strands, grown));
    std::fflush(stdout);
  }
  use_sets_without(0);
  std::printf("\n| everything, %d strands, threads | ns, CPU of all threads | ns, wall |\n|---|--:|--:|\n",
              strands);
  for (const int threads : {1, 2}) {
    FullHeadSettings settings = with(true, true, true);
    settings.threads = threads;
    std::printf("| %d | %.1f | %.1f |\n", threads, engine_ns(settings, strands, grown),
                engine_ns(settings, strands, grown, timing::wall_seconds));
  }
}

void by_peaks() {
  std::printf("\n| one core, of CPU time | at most |\n|---|--:|\n");
  std::printf("| 1e9 operations per second | %.0f |\n| GB/s | %.1f |\n", 1e-9 * arithmetic_peak(),
              1e-9 * bandwidth());
  std::fflush(stdout);
}

}  // namespace hair_bench

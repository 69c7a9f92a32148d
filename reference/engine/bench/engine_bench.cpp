// STAFF ONLY. Measures the cost of a step of the engine, compared with given code, and prints Markdown. It
// takes the least CPU time of some steps, so that other programs on the machine matter less. Usage:
// engine_bench [STRANDS].
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>

#include "hair/dense/full_head.h"
#include "hair/head/bust.h"
#include "hair/head/grow.h"
#include "hair/length_correction.h"
#include "hair/obstacles/obstacles.h"
#include "hair/predictor_corrector.h"
#include "particles/implicit_euler.h"
#include "reference/engine/head_of_strands.h"
#include "solver/timing.h"

namespace hair_bench {

using Eigen::VectorXd;
using hair::FullHead, hair::FullHeadSettings, hair::Vector3d;

namespace {

constexpr int kPoints = 25;
constexpr double kStep = 1.0 / 24;  // s
constexpr int kWarmUp = 4, kSteps = 6;

// The order along a curve that fills space: Morton's order of cells of 2 mm.
std::int64_t place_on_curve(const Vector3d& root) {
  std::int64_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::int64_t>((root[axis] + 1) / 2e-3);
    for (int bit = 0; bit < 12; ++bit) place |= ((cell >> bit) & 1) << (3 * bit + axis);
  }
  return place;
}

// Hair on the bust, combed. Neighbours follow each other.
hair::Groom combed_groom(int strands) {
  const hair::HairStyle* const style = hair::find_hair_style("long-smooth");
  if (!style) throw std::runtime_error("no style long-smooth");
  hair::Groom groom = grow_groom(hair::Bust(), *style, {strands, kPoints, 1});
  std::sort(groom.strands.begin(), groom.strands.end(), [](const VectorXd& a, const VectorXd& b) {
    return place_on_curve(a.head<3>()) < place_on_curve(b.head<3>());
  });
  return groom;
}

// The strands of `head` take the groom's in turn.
void set(FullHead& head, const hair::Groom& groom) {
  const VectorXd still = VectorXd::Zero(3 * kPoints);
  for (int k = 0; k < head.strands(); ++k) {
    const VectorXd& x = groom.strands[k % groom.strands.size()];
    double length = 0;
    for (int i = 1; i < kPoints; ++i) length += (x.segment<3>(3 * i) - x.segment<3>(3 * i - 3)).norm();
    head.set_strand(k, length / (kPoints - 1), (x.segment<3>(3) - x.head<3>()).normalized(), x, still);
  }
}

FullHeadSettings with(bool bending, bool correction, bool contact) {
  FullHeadSettings settings;
  settings.drag = 2;
  settings.bending = bending;
  settings.correct_lengths = correction;
  if (contact) settings.head = std::make_shared<hair::Bust>();
  settings.friction = 0.3;
  return settings;
}

// The least of some times, in seconds.
double least(int times, const std::function<void()>& work, double (*clock)() = timing::process_cpu_seconds) {
  double least = INFINITY;
  for (int i = 0; i < times; ++i) {
    const double start = clock();
    work();
    least = std::min(least, clock() - start);
  }
  return least;
}

// The ns per particle and step, in CPU time with the clock for it. Sets `bytes`, if not null, to the bytes
// that a particle takes.
double engine_ns(const FullHeadSettings& settings, int strands, const hair::Groom& groom,
                 double (*clock)() = timing::process_cpu_seconds, double* bytes = nullptr) {
  FullHead head(std::vector<int>(strands, kPoints), settings);
  set(head, groom);
  for (int i = 0; i < kWarmUp; ++i) head.step(kStep);
  const int repeat = std::max(1, 4'000 / strands);
  const double seconds = least(
      kSteps,
      [&] {
        for (int i = 0; i < repeat; ++i) head.step(kStep);
      },
      clock);
  if (head.broken()) std::printf("%d strands broke\n", head.broken());
  if (bytes) *bytes = static_cast<double>(head.bytes()) / static_cast<double>(head.particles());
  return 1e9 * seconds / repeat / static_cast<double>(head.particles());
}

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

void by_instruction_set(const hair::Groom& grown) {
  std::printf("\n| everything, one thread | ns | strand steps a second |\n|---|--:|--:|\n");
  const struct {
    const char* name;
    std::int64_t target;
  } sets[] = {{"AVX-512", HWY_AVX3}, {"AVX2", HWY_AVX2}, {"neither", HWY_SCALAR}};
  for (const auto& [name, target] : sets) {
    hwy::DisableTargets(target - 1);  // better targets have smaller numbers
    const std::int64_t supported = hwy::SupportedTargets();
    if (!(supported & target)) continue;
    hwy::GetChosenTarget().Update(supported);
    const double ns = engine_ns(with(true, true, true), 4'000, grown);
    std::printf("| %s | %.1f | %.0f |\n", name, ns, 1e9 / (ns * kPoints));
  }
  hwy::DisableTargets(0);
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
  std::printf("\n%s\n", memory.c_str());
}

void by_threads(int strands, const hair::Groom& grown) {
  std::printf("\n| everything, %d strands, threads | ns, CPU of all threads | ns, wall |\n|---|--:|--:|\n",
              strands);
  for (const int threads : {1, 2}) {
    FullHeadSettings settings = with(true, true, true);
    settings.threads = threads;
    std::printf("| %d | %.1f | %.1f |\n", threads, engine_ns(settings, strands, grown),
                engine_ns(settings, strands, grown, timing::wall_seconds));
  }
}

}  // namespace
}  // namespace hair_bench

int main(int count, char** arguments) {
  using namespace hair_bench;
  const int strands = count > 1 ? std::atoi(arguments[1]) : 20'000;
  if (strands < 1) {
    std::fprintf(stderr, "engine_bench: STRANDS is \"%s\"; it must be a number of at least 1\n",
                 arguments[1]);
    return 2;
  }
  const hair::Groom grown = combed_groom(std::min(strands, 20'000));
  by_parts(strands, grown);
  by_instruction_set(grown);
  by_strands(grown);
  by_threads(strands, grown);
}

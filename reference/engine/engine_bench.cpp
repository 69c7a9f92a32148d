// STAFF ONLY. What a step of the engine costs: by its parts, by the number of strands, by instruction set, on one thread and on two; beside
// given code, Bullet's rope and plain XPBD. Usage: engine_bench [STRANDS]. CPU times, so that other programs on the machine matter less:
// the least of some steps. Prints Markdown.

#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>

#include "hair/bench/bullet_rope.h"
#include "hair/head/bust.h"
#include "hair/head/grow.h"
#include "hair/length_correction.h"
#include "hair/predictor_corrector.h"
#include "hair/strand/measures.h"
#include "hair/strand/obstacles.h"
#include "particles/implicit_euler.h"
#include "particles/preconditioner.h"
#include "reference/engine/block_solves.h"
#include "reference/engine/head_of_strands.h"
#include "reference/engine/peaks.h"
#include "reference/engine/plain_xpbd.h"
#include "solver/timing.h"

namespace {

using Eigen::VectorXd;
using hair::FullHead, hair::FullHeadSettings, hair::Vector3d;

constexpr int kPoints = 25;
constexpr double kStep = 1.0 / 24;
constexpr int kWarmUp = 4, kSteps = 6;

// Along a curve that fills space: Morton's order of cells of 2 mm.
std::int64_t place_on_curve(const Vector3d& root) {
  std::int64_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::int64_t>((root[axis] + 1) / 2e-3);
    for (int bit = 0; bit < 12; ++bit) place |= ((cell >> bit) & 1) << (3 * bit + axis);
  }
  return place;
}

// Hair on the bust, combed.
hair::Groom groom(int strands) {
  const hair::HairStyle* const style = hair::find_hair_style("long-smooth");
  if (!style) throw std::runtime_error("no style long-smooth");
  hair::Groom groom = grow_groom(hair::Bust(), *style, {strands, kPoints, 1});
  // Neighbours follow each other.
  std::sort(groom.strands.begin(), groom.strands.end(), [](const VectorXd& a, const VectorXd& b) {
    return place_on_curve(a.head<3>()) < place_on_curve(b.head<3>());
  });
  return groom;
}

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

double least(int times, const std::function<void()>& work, double (*clock)() = timing::process_cpu_seconds) {
  double least = INFINITY;
  for (int i = 0; i < times; ++i) {
    const double start = clock();
    work();
    least = std::min(least, clock() - start);
  }
  return least;
}

// ns per particle and step, of CPU time if the clock says so.
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
  std::printf("\n%s\n", memory.c_str());
}

// For engines made from now on.
void use_sets_without(long long disabled) {
  hwy::DisableTargets(disabled);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

void by_set(int strands, const hair::Groom& grown) {
  std::printf("\n| everything, %d strands | ns |\n|---|--:|\n", strands);
  const struct {
    const char* name;
    long long disabled;
  } sets[] = {{"AVX-512", 0},
              {"AVX2", HWY_AVX3 | HWY_AVX3_DL},
              {"scalars", HWY_AVX3 | HWY_AVX3_DL | HWY_AVX2 | HWY_SSE4 | HWY_SSSE3}};
  const auto here = hwy::SupportedTargets();
  for (const auto& [name, disabled] : sets) {
    if (disabled == 0 && !(here & HWY_AVX3)) continue;
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
    hair_bench::BulletRope rope(strand, iterations);
    report(
        "Bullet's rope, " + std::to_string(iterations) + " iterations", 1, [&] { rope.step(h); },
        [&] { return rope.positions(); });
  }
  for (int iterations = 10; iterations <= 1'000'000; iterations *= 10) {
    hair_bench::PlainXpbd rope(strand, start->state.x, iterations);
    const double reached = report(
        "plain XPBD, " + std::to_string(iterations) + " iterations", 1, [&] { rope.step(h); },
        [&] { return rope.positions(); });
    if (reached <= stretch) break;
  }
}

void by_peaks() {
  std::printf("\n| one core, of CPU time | at most |\n|---|--:|\n");
  std::printf("| 1e9 operations per second | %.0f |\n| GB/s | %.1f |\n", 1e-9 * hair_bench::arithmetic_peak(),
              1e-9 * hair_bench::bandwidth());
  std::fflush(stdout);
}

// Points after a second in which the head turns to a side and back, beside those of steps of 1/3840 s.
void by_step(const hair::Groom& grown) {
  constexpr int kStrands = 400;
  const FullHeadSettings settings = with(true, true, true);
  const auto points = [&](int steps) {
    FullHead head(std::vector<int>(kStrands, kPoints), settings);
    hair::Groom some;
    for (int k = 0; k < kStrands; ++k)
      some.strands.push_back(grown.strands[k * (grown.strands.size() - 1) / (kStrands - 1)]);
    set(head, some);
    for (int i = 1; i <= steps; ++i) {
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      const double s = std::sin(std::numbers::pi * i / steps);
      pose.linear() = Eigen::AngleAxisd(s * s, Vector3d::UnitZ()).toRotationMatrix();
      head.step(1.0 / steps, pose);
    }
    if (head.broken()) std::printf("%d strands broke\n", head.broken());
    std::vector<VectorXd> all(kStrands, VectorXd(3 * kPoints));
    VectorXd v(3 * kPoints);
    for (int k = 0; k < kStrands; ++k) head.get_strand(k, all[k], v);
    return all;
  };
  const auto exact = points(3840);
  std::printf(
      "\n| h, s | mean error, mm | of the tips | 95 %% of all points are better than |\n|--:|--:|--:|--:|\n");
  for (const int steps : {24, 60, 240, 960}) {
    const auto all = points(steps);
    std::vector<double> errors;
    double sum = 0, tips = 0;
    for (int k = 0; k < kStrands; ++k)
      for (int i = 1; i < kPoints; ++i) {
        errors.push_back(1e3 * (all[k] - exact[k]).segment<3>(3 * i).norm());
        sum += errors.back();
        if (i == kPoints - 1) tips += errors.back();
      }
    std::sort(errors.begin(), errors.end());
    std::printf("| 1/%d | %.1f | %.1f | %.1f |\n", steps, sum / static_cast<double>(errors.size()),
                tips / kStrands, errors[errors.size() * 95 / 100]);
  }
  std::fflush(stdout);
}

// How far off a solve is, relative to its solution, of a strand that hangs bent; by h^2 k / m of its segments. Real hair of segments of
// 1 cm has 6e6 at h = 1/60 s.
void by_precision() {
  std::printf(
      "\n| h^2 k / m | single, L D L^T | single, cofactors | double, L D L^T | double, cofactors "
      "|\n|--:|--:|--:|--:|--:|\n");
  FullHeadSettings settings = with(true, false, false);
  constexpr double h = 1.0 / 60, l0 = 0.01;
  const double hair =
      h * h * settings.material.stretch_rigidity() / settings.material.line_density() / (l0 * l0);
  for (const double ratio : {1e3, 1e4, 1e5, 1e6, 6.5e6, 4e7, 1e9, 1e11, 1e13}) {
    const auto moving = hair::engine::given_strand(settings, kPoints, l0, Vector3d::UnitX());
    moving->strand.stretch_rigidity *= ratio / hair;
    VectorXd& x = moving->state.x;
    for (int i = 1; i < kPoints; ++i)
      x.segment<3>(3 * i) =
          x.segment<3>(3 * i - 3) + l0 * Vector3d(std::cos(0.1 * i), std::sin(0.1 * i) * std::cos(0.3 * i),
                                                  std::sin(0.1 * i) * std::sin(0.3 * i));
    Eigen::MatrixXd memory(3 * kPoints, solver::BlockBand::kColumns), work(3 * kPoints, 2);
    solver::BlockBand band(memory);
    if (!particles::preconditioner::assemble(moving->force, moving->particles, moving->state, h, h, work,
                                             band))
      throw std::runtime_error("no band");
    VectorXd rhs = VectorXd::Zero(3 * kPoints);
    moving->force.add_force(x, moving->state.v, rhs);
    rhs.head<3>().setZero();
    const VectorXd exact = hair_bench::solve_blocks<long double>(band, rhs, hair_bench::Inverse::ldlt);
    std::printf("| %.1e |", ratio);
    const auto error = [&](const VectorXd& solution) {
      std::printf(" %.1e |", (solution - exact).norm() / exact.norm());
    };
    for (const auto inverse : {hair_bench::Inverse::ldlt, hair_bench::Inverse::cofactors})
      error(hair_bench::solve_blocks<float>(band, rhs, inverse));
    for (const auto inverse : {hair_bench::Inverse::ldlt, hair_bench::Inverse::cofactors})
      error(hair_bench::solve_blocks<double>(band, rhs, inverse));
    std::printf("\n");
  }
}

}  // namespace

int main(int count, char** arguments) {
  const int strands = count > 1 ? std::atoi(arguments[1]) : 20'000;
  if (strands < 1) {
    std::fprintf(stderr, "engine_bench: STRANDS is \"%s\"; it must be a number of at least 1\n",
                 arguments[1]);
    return 2;
  }
  const hair::Groom grown = groom(std::min(strands, 20'000));
  by_parts(strands, grown);
  by_strands(grown);
  by_set(strands, grown);
  by_peaks();
  by_step(grown);
  beside_others();
  by_precision();
}

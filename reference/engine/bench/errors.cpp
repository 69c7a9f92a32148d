// STAFF ONLY. How far off the engine's steps are, and solves in other arithmetic.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "particles/preconditioner.h"
#include "reference/engine/bench/bench_head.h"
#include "reference/engine/bench/block_solves.h"
#include "reference/engine/bench/tables.h"
#include "reference/engine/head_of_strands.h"

namespace hair_bench {

using Eigen::VectorXd;
using hair::FullHead, hair::FullHeadSettings, hair::Vector3d;

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
    particles::preconditioner::add_identity_of_pinned(moving->particles, band);
    VectorXd rhs = VectorXd::Zero(3 * kPoints);
    moving->force.add_force(x, moving->state.v, rhs);
    rhs.head<3>().setZero();
    const VectorXd exact = solve_blocks<long double>(band, rhs, Inverse::ldlt);
    std::printf("| %.1e |", ratio);
    const auto error = [&](const VectorXd& solution) {
      std::printf(" %.1e |", (solution - exact).norm() / exact.norm());
    };
    for (const auto inverse : {Inverse::ldlt, Inverse::cofactors})
      error(solve_blocks<float>(band, rhs, inverse));
    for (const auto inverse : {Inverse::ldlt, Inverse::cofactors})
      error(solve_blocks<double>(band, rhs, inverse));
    std::printf("\n");
  }
}

}  // namespace hair_bench

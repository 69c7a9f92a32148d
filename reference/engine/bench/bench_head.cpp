// STAFF ONLY.
#include "reference/engine/bench/bench_head.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "hair/head/bust.h"
#include "hair/head/grow.h"

namespace hair_bench {

using Eigen::VectorXd;
using hair::FullHead, hair::FullHeadSettings, hair::Vector3d;

namespace {

// Along a curve that fills space: Morton's order of cells of 2 mm.
std::int64_t place_on_curve(const Vector3d& root) {
  std::int64_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::int64_t>((root[axis] + 1) / 2e-3);
    for (int bit = 0; bit < 12; ++bit) place |= ((cell >> bit) & 1) << (3 * bit + axis);
  }
  return place;
}

}  // namespace

hair::Groom combed_groom(int strands) {
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

double least(int times, const std::function<void()>& work, double (*clock)()) {
  double least = INFINITY;
  for (int i = 0; i < times; ++i) {
    const double start = clock();
    work();
    least = std::min(least, clock() - start);
  }
  return least;
}

double engine_ns(const FullHeadSettings& settings, int strands, const hair::Groom& groom, double (*clock)(),
                 double* bytes) {
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

}  // namespace hair_bench

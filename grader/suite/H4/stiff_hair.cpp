// STAFF ONLY.
#include "grader/suite/H4/stiff_hair.h"

#include "particles/force_sum.h"
#include "particles/products_to_band.h"
#include "particles/springs.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;
using particles::Input, particles::Output, particles::Spring;

// Springs between neighbours and theirs.
class NearSprings final : public particles::DampedSprings {
 public:
  explicit NearSprings(const std::vector<Spring>& springs)
      : DampedSprings(springs, particles::Products::definite) {}
  bool add_band(Input x, Input v, double by_dfdx, double, solver::BlockBand& band,
                particles::Scratch work) const override {
    return particles::add_products(
        2, by_dfdx, [&](Input dx, Output df) { add_dfdx(x, v, dx, df); }, band, work);
  }
};

// A spring whose part of the band is left out.
class FarSpring final : public particles::DampedSprings {
 public:
  explicit FarSpring(const Spring& spring) : DampedSprings({spring}, particles::Products::definite) {}
  bool add_band(Input, Input, double, double, solver::BlockBand&, particles::Scratch) const override {
    return true;
  }
};

}  // namespace

Cloud stiff_hair(Random& random, int n, double h, bool far) {
  constexpr double kMass = 1e-7, kLength = 0.01;
  Cloud hair;
  hair.name = "a stiff hair of " + std::to_string(n) + " particles" + (far ? " with one spring more" : "");
  hair.particles = {VectorXd::Zero(n), std::vector<char>(n, 0)};
  hair.particles.pinned[0] = 1;
  hair.state = {VectorXd::Zero(3 * n), random_vector(random, 3 * n, 0.01)};
  for (int i = 0; i < n; ++i) hair.particles.mass[i] = kMass * random.uniform(0.7, 1.4);
  for (int i = 1; i < n; ++i)
    hair.state.x.segment<3>(3 * i) = hair.state.x.segment<3>(3 * i - 3) + Eigen::Vector3d(kLength, 0, 0) +
                                     Eigen::Vector3d(random_vector(random, 3, 0.1 * kLength));
  const auto spring = [&](int i, int j, double stiff) {
    const double length = (hair.state.x.segment<3>(3 * j) - hair.state.x.segment<3>(3 * i)).norm();
    return Spring{i, j, stiff * kMass / (h * h), length * random.uniform(0.999, 1)};
  };
  const double stiff = random.log_uniform(1e4, 1e6);
  std::vector<Spring> springs;
  for (int i = 0; i + 1 < n; ++i) springs.push_back(spring(i, i + 1, stiff));
  for (int i = 0; i + 2 < n; ++i) springs.push_back(spring(i, i + 2, 0.01 * stiff));
  auto forces = std::make_shared<particles::ForceSum>();
  forces->emplace<NearSprings>(springs);
  if (far) forces->emplace<FarSpring>(spring(1, n - 1, 10));
  hair.force = forces;
  return hair;
}

}  // namespace grader::h4

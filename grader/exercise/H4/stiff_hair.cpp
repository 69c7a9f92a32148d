// STAFF ONLY.
#include "grader/exercise/H4/stiff_hair.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "particles/drag.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/products_to_band.h"
#include "particles/springs.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;
using particles::Input, particles::Output, particles::Spring;

// Springs between neighbours and theirs.
class NearSprings final : public particles::DampedSprings {
 public:
  explicit NearSprings(const std::vector<Spring>& springs,
                       particles::Products products = particles::Products::definite)
      : DampedSprings(springs, products) {}
  bool add_band(Input x, Input v, double by_dfdx, double, solver::BlockBand& band,
                particles::Scratch work) const override {
    return particles::add_products(
        2, by_dfdx, [&](Input dx, Output df) { add_dfdx(x, v, dx, df); }, band, work);
  }
};

// A spring whose part of the band is left out.
class FarSpring final : public particles::DampedSprings {
 public:
  explicit FarSpring(const Spring& spring, particles::Products products = particles::Products::definite)
      : DampedSprings({spring}, products) {}
  bool add_band(Input, Input, double, double, solver::BlockBand&, particles::Scratch) const override {
    return true;
  }
};

// Another force where units are `mass` and `length` times as small.
class InOtherUnits final : public particles::Force {
 public:
  InOtherUnits(std::shared_ptr<const particles::Force> force, double mass, double length)
      : force_(std::move(force)), mass_(mass), length_(length) {}
  double energy(Input x) const override { return mass_ * length_ * length_ * force_->energy(x / length_); }
  void add_force(Input x, Input v, Output f) const override {
    VectorXd sum = VectorXd::Zero(f.size());
    force_->add_force(x / length_, v / length_, sum);
    f += mass_ * length_ * sum;
  }
  void add_dfdx(Input x, Input v, Input dx, Output df) const override {
    VectorXd sum = VectorXd::Zero(df.size());
    force_->add_dfdx(x / length_, v / length_, dx, sum);
    df += mass_ * sum;
  }
  void add_dfdv(Input x, Input v, Input dv, Output df) const override {
    VectorXd sum = VectorXd::Zero(df.size());
    force_->add_dfdv(x / length_, v / length_, dv, sum);
    df += mass_ * sum;
  }
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                particles::Scratch work) const override {
    return force_->add_band(x / length_, v / length_, mass_ * by_dfdx, mass_ * by_dfdv, band, work);
  }

 private:
  std::shared_ptr<const particles::Force> force_;
  double mass_, length_;
};

// A chain under gravity, h^2 k/m = `stiff`, no spring stretched.
template <class Springs>
Cloud under_gravity(Random& random, int n, double stiff, double h) {
  Cloud hair = chain(random, n, 1e-7, stiff, h);
  hair.name = "a hair under gravity";
  hair.state.v.setZero();
  std::vector<Spring> springs;
  for (int i = 1; i < n; ++i) {
    const double length = (hair.state.x.segment<3>(3 * i) - hair.state.x.segment<3>(3 * i - 3)).norm();
    springs.push_back({i - 1, i, stiff * 1e-7 / (h * h), length});
  }
  auto forces = std::make_shared<particles::ForceSum>();
  forces->emplace<Springs>(springs, particles::Products::definite);
  forces->emplace<particles::Gravity>(hair.particles.mass, Eigen::Vector3d(0, 0, -9.81));
  hair.force = forces;
  return hair;
}

}  // namespace

Cloud stiff_hair(Random& random, int n, double h, int far, double drag) {
  constexpr double kMass = 1e-7, kLength = 0.01;
  Cloud hair;
  hair.name = "a stiff hair of " + std::to_string(n) + " particles" + " with " + std::to_string(far) +
              " springs more";
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
  for (int i = 0; i < far; ++i) forces->emplace<FarSpring>(spring(1 + i, n - 1 - i, 10));
  if (drag > 0) forces->emplace<particles::Drag>(VectorXd::Constant(n, drag * kMass / h));
  hair.force = forces;
  return hair;
}

Cloud hair_without_band(Random& random, double h) {
  Cloud hair = chain(random, 6, 1e-7, 1e4, h);
  hair.name = "a hair whose band knows of no spring";
  for (double& mass : hair.particles.mass) mass *= random.log_uniform(1, 1e6);
  auto forces = std::make_shared<particles::ForceSum>();
  for (int i = 1; i < hair.count(); ++i)
    forces->emplace<FarSpring>(Spring{i - 1, i, 1e4 * 1e-7 / (h * h), 0.01 * random.uniform(0.9, 1)});
  hair.force = forces;
  return hair;
}

Cloud compressed_without_band(Random& random, double h) {
  Cloud hair = chain(random, 6, 1e-7, 1e4, h);
  hair.name = "a compressed hair whose band knows of no spring";
  auto forces = std::make_shared<particles::ForceSum>();
  for (int i = 1; i < hair.count(); ++i)
    forces->emplace<FarSpring>(Spring{i - 1, i, 1e4 * 1e-7 / (h * h), 0.01 * random.uniform(2, 3)},
                               particles::Products::exact);
  hair.force = forces;
  return hair;
}

Cloud tangle_without_band(Random& random, int n, double h) {
  constexpr double kMass = 1e-7;
  Cloud hair = chain(random, n, kMass, 1, h);
  hair.name = "a tangle whose band knows of no spring";
  auto forces = std::make_shared<particles::ForceSum>();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) {
      const double length = (hair.state.x.segment<3>(3 * i) - hair.state.x.segment<3>(3 * j)).norm();
      forces->emplace<FarSpring>(
          Spring{j, i, random.log_uniform(1, 1e6) * kMass / (h * h), length * random.uniform(0.9, 1)});
    }
  hair.force = forces;
  return hair;
}

Cloud in_other_units(const Cloud& hair, double mass, double length) {
  Cloud other = hair;
  other.name += ", in other units";
  other.particles.mass *= mass;
  other.state.x *= length;
  other.state.v *= length;
  other.force = std::make_shared<InOtherUnits>(hair.force, mass, length);
  return other;
}

Cloud hanging_hair(Random& random, int n, double stiff, double h) {
  return under_gravity<particles::DampedSprings>(random, n, stiff, h);
}

Cloud hanging_hair_with_band(Random& random, int n, double stiff, double h) {
  return under_gravity<NearSprings>(random, n, stiff, h);
}

}  // namespace grader::h4

#include "particles/toys/moving_toy.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "particles/drag.h"
#include "particles/gravity.h"
#include "particles/require.h"
#include "particles/system.h"

namespace particles {

namespace {

void check_index(const std::string& what, int i, int n) {
  require(i >= 0 && i < n, what, i, "a particle, from 0 to " + std::to_string(n - 1));
}

void check(const Toy& toy) {
  const int n = toy.particles.count();
  require(static_cast<int>(toy.particles.pinned.size()) == n, "a toy: the numbers of `pinned`",
          static_cast<double>(toy.particles.pinned.size()), std::to_string(n));
  require(toy.start.x.size() == 3 * n, "a toy: the numbers in x", static_cast<double>(toy.start.x.size()),
          std::to_string(3 * n));
  require(toy.start.v.size() == 3 * n, "a toy: the numbers in v", static_cast<double>(toy.start.v.size()),
          std::to_string(3 * n));
  for (double mass : toy.particles.mass) require_positive("a toy: a mass", mass);
  require_finite("a toy: a position", toy.start.x);
  require_finite("a toy: a velocity", toy.start.v);
  require_finite("a toy: gravity", toy.gravity);
  require_finite("a toy: the wind", toy.wind);
  require_at_least("a toy: the drag", toy.drag, 0);
  for (const Spring& spring : toy.springs) {
    check_index("a spring's end", spring.i, n);
    check_index("a spring's end", spring.j, n);
  }
  for (const Rod& rod : toy.constraints.rods) {
    check_index("a rod's end", rod.i, n);
    check_index("a rod's end", rod.j, n);
    require(rod.i != rod.j, "a rod's other end", rod.j, "another particle");
    require_positive("a rod's length", rod.length);
  }
  for (const Wire& wire : toy.constraints.wires) {
    check_index("a wire's particle", wire.i, n);
    require_finite("a wire's centre", wire.centre);
    require(std::abs(wire.normal.norm() - 1) <= 1e-9, "the length of a wire's normal", wire.normal.norm(),
            "1");
    require_positive("a wire's radius", wire.radius);
  }
  require_at_least("the constraints' stiffness", toy.constraints.stiffness, 0);
  require_at_least("the constraints' damping", toy.constraints.damping, 0);
}

Vector3d between(Input x, int i, int j) {
  return x.segment<3>(3 * i) - x.segment<3>(3 * j);
}

// NaN if either is NaN.
double worse(double stretch, const Vector3d& between, double rest_length) {
  if (rest_length == 0) return stretch;
  const double other = std::abs(between.norm() / rest_length - 1);
  return std::isnan(stretch) || other <= stretch ? stretch : other;
}

}  // namespace

MovingToy::MovingToy(const Toy& description, bool watched) : toy(description), state(toy.start) {
  check(toy);
  const bool implicit = toy.method == ToyMethod::implicit_euler, held = toy.constraints.rows() > 0;
  if (implicit && held)
    throw std::invalid_argument("a toy: rods and wires need an explicit method, not implicit Euler");

  if (toy.gravity != Vector3d::Zero()) force.emplace<Gravity>(toy.particles.mass, toy.gravity);
  if (!toy.springs.empty())
    force.emplace<DampedSprings>(toy.springs, implicit ? Products::definite : Products::exact);
  if (toy.drag > 0) force.emplace<Drag>(Eigen::VectorXd::Constant(toy.particles.count(), toy.drag), toy.wind);

  if (held) {
    dynamics = constrained_dynamics(*this, watched);
  } else if (!implicit) {
    dynamics = std::make_unique<ParticleSystem>(toy.particles, force);
  }
}

ToyStep toy_step_of(ToyMethod method) {
  static constexpr const ToyStep* kSteps[] = {&kToyForwardEuler, &kToySymplecticEuler, &kToyMidpoint,
                                              &kToyRungeKutta4, &kToyImplicitEuler};
  return *kSteps[static_cast<std::size_t>(method)];
}

std::vector<std::string> exercises_of_constraints(const Toy& toy) {
  if (toy.constraints.rows() == 0) return {};
  return {"S1", "P2"};
}

double largest_stretch(const Toy& toy, Input x) {
  double stretch = largest_rod_stretch(toy, x);
  for (const Spring& spring : toy.springs)
    stretch = worse(stretch, between(x, spring.i, spring.j), spring.rest_length);
  return stretch;
}

double largest_rod_stretch(const Toy& toy, Input x) {
  double stretch = 0;
  for (const Rod& rod : toy.constraints.rods) stretch = worse(stretch, between(x, rod.i, rod.j), rod.length);
  return stretch;
}

}  // namespace particles

// STAFF ONLY. Particles under a force, and the system of an implicit step as a table, so that the suite can
// compute the error of a dv without a solver.
//
// Bounds. With u = 2^-53, A the matrix, e the rounding of a product with it over u ||A||, X = 2 ||dv*|| +
// ||rhs||, solver/linearSolver.h gives, as in linear_system.h,
//
//   ||rhs - A dv|| <= tolerance ||rhs|| + 65 (10 + 2e) u ||A|| X,   ||dv - dv*|| <= that / lambda_min,
//
// with ||A|| the norm of the matrix of all |a_ij|, at most Frobenius'. e: our product sums 3n terms for
// each of df/dx and df/dv, and a few more operations combine them: 2 (3n + 8). The right-hand side has the
// same rounding error.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "grader/judge/cases/random.h"
#include "particles/force.h"
#include "particles/implicit_euler.h"
#include "particles/products_to_band.h"
#include "particles/state.h"

namespace grader::inline judge {

struct Cloud {
  std::string name;
  particles::Particles particles;
  particles::State state;
  std::shared_ptr<const particles::Force> force;

  int count() const { return particles.count(); }
};

// f = f0 - K x - s x^3 - D v, with full symmetric, positive definite tables K and D, and the cube of each
// coordinate: all coordinates are coupled, and df/dx depends on x.
class CoupledForce : public particles::Force {
 public:
  // Makes n particles; the eigenvalues of K and D are about `stiffness` (N/m) and `damping` (N s/m).
  CoupledForce(Random& random, int n, double stiffness, double damping);

  double energy(particles::Input x) const override;
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override;
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override;
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override;

 private:
  Eigen::VectorXd f0_, cubic_;
  Eigen::MatrixXd K_, D_;
};

// The same, with a damping that depends on a coordinate and its velocity:
//
//   -q x^2 v - p v^3,   d/dx: -2 q x v,   d/dv: -q x^2 - 3 p v^2,
//
// so that df/dx depends on v, and df/dv on x and v. q is so small that K outweighs 2 q x v.
class MixedForce final : public CoupledForce {
 public:
  MixedForce(Random& random, int n, double stiffness, double damping);

  void add_force(particles::Input x, particles::Input v, particles::Output f) const override;
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override;
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override;

 private:
  double q_, p_;
};

// n particles at random positions, with masses between `lightest` and `heaviest`.
Cloud random_cloud(Random& random, std::string name, int n, double lightest, double heaviest,
                   double stiffness, double damping);

// A chain of springs with lengths of about 1 cm, slightly stretched and turned, whose root is pinned. The
// masses are about `mass`; the stiffness k is such that h^2 k / m = `stiff`.
Cloud chain(Random& random, int n, double mass, double stiff, double h);

// Returns the same cloud with masses times `mass`, lengths and velocities times `length`, and the same times.
Cloud in_other_units(const Cloud& cloud, double mass, double length);

struct ImplicitSystem {
  Eigen::MatrixXd A;
  Eigen::VectorXd rhs, dv;  // dv is the solution
  // `norm` is the Frobenius norm of A's part of free particles, `smallest` A's smallest eigenvalue. A pinned
  // particle's rows round nothing, and their 1 would hide the small masses of hair.
  double norm, smallest;
  double rounding;  // 65 (10 + 2e) u ||A|| X, plus that of the right-hand side

  double residual(const Eigen::VectorXd& other) const { return (rhs - A * other).norm(); }
};

ImplicitSystem implicit_system(const Cloud& cloud, double a, double b);

// Wraps another force; its children change one property.
class OtherForce : public particles::Force {
 public:
  explicit OtherForce(std::shared_ptr<const particles::Force> force) : force_(std::move(force)) {}
  double energy(particles::Input x) const override { return force_->energy(x); }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    force_->add_force(x, v, f);
  }
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override {
    force_->add_dfdx(x, v, dx, df);
  }
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override {
    force_->add_dfdv(x, v, dv, df);
  }

 protected:
  std::shared_ptr<const particles::Force> force_;
};

// Reports the band of df/dx: particles more than two apart are not coupled.
class Banded final : public OtherForce {
 public:
  using OtherForce::OtherForce;
  bool add_band(particles::Input x, particles::Input v, double by_dfdx, double /*by_dfdv*/,
                solver::BlockBand& band, particles::Scratch work) const override {
    const auto product = [&](particles::Input dx, particles::Output df) { add_dfdx(x, v, dx, df); };
    return particles::add_products(2, by_dfdx, product, band, work);
  }
};

}  // namespace grader::judge

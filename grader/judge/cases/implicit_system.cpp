// STAFF ONLY. Makes forces, particles and the table of an implicit step.
#include "grader/judge/cases/implicit_system.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <utility>

#include "grader/judge/cases/random.h"
#include "particles/springs.h"
#include "solver/dense_algebra.h"

namespace grader::inline judge {
namespace {

// Returns a symmetric matrix with eigenvalues between half of `size` and about five times it.
Eigen::MatrixXd definite(Random& random, int n, double size) {
  Eigen::MatrixXd R(n, n);
  for (double& entry : R.reshaped()) entry = random.normal();
  return size * (R * R.transpose() / n + 0.5 * Eigen::MatrixXd::Identity(n, n));
}

// Wraps another force in units that are `mass` and `length` times as small.
class InOtherUnits final : public particles::Force {
 public:
  InOtherUnits(std::shared_ptr<const particles::Force> force, double mass, double length)
      : force_(std::move(force)), mass_(mass), length_(length) {}
  double energy(particles::Input x) const override {
    return mass_ * length_ * length_ * force_->energy(x / length_);
  }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(f.size());
    force_->add_force(x / length_, v / length_, sum);
    f += mass_ * length_ * sum;
  }
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(df.size());
    force_->add_dfdx(x / length_, v / length_, dx, sum);
    df += mass_ * sum;
  }
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(df.size());
    force_->add_dfdv(x / length_, v / length_, dv, sum);
    df += mass_ * sum;
  }

 private:
  std::shared_ptr<const particles::Force> force_;
  double mass_, length_;
};

}  // namespace

CoupledForce::CoupledForce(Random& random, int n, double stiffness, double damping)
    : f0_(random_vector(random, 3 * n, stiffness)),
      cubic_(3 * n),
      K_(definite(random, 3 * n, stiffness)),
      D_(definite(random, 3 * n, damping)) {
  for (double& value : cubic_) value = stiffness * random.uniform(0.5, 2);
}

double CoupledForce::energy(particles::Input x) const {
  return -f0_.dot(x) + 0.5 * x.dot(K_ * x) + 0.25 * (cubic_.array() * x.array().pow(4)).sum();
}

void CoupledForce::add_force(particles::Input x, particles::Input v, particles::Output f) const {
  f += f0_ - K_ * x - D_ * v - (cubic_.array() * x.array().cube()).matrix();
}

void CoupledForce::add_dfdx(particles::Input x, particles::Input, particles::Input dx,
                            particles::Output df) const {
  df -= K_ * dx + (3 * cubic_.array() * x.array().square() * dx.array()).matrix();
}

void CoupledForce::add_dfdv(particles::Input, particles::Input, particles::Input dv,
                            particles::Output df) const {
  df -= D_ * dv;
}

// In random_cloud's states |2 q x v| is 0.1 `stiffness` where x and v are three times their usual size.
MixedForce::MixedForce(Random& random, int n, double stiffness, double damping)
    : CoupledForce(random, n, stiffness, damping), q_(0.01 * stiffness), p_(0.1 * damping) {}

void MixedForce::add_force(particles::Input x, particles::Input v, particles::Output f) const {
  CoupledForce::add_force(x, v, f);
  f -= (q_ * x.array().square() * v.array() + p_ * v.array().cube()).matrix();
}

void MixedForce::add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                          particles::Output df) const {
  CoupledForce::add_dfdx(x, v, dx, df);
  df -= (2 * q_ * x.array() * v.array() * dx.array()).matrix();
}

void MixedForce::add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                          particles::Output df) const {
  CoupledForce::add_dfdv(x, v, dv, df);
  df -= ((q_ * x.array().square() + 3 * p_ * v.array().square()) * dv.array()).matrix();
}

Cloud random_cloud(Random& random, std::string name, int n, double lightest, double heaviest,
                   double stiffness, double damping) {
  Cloud cloud;
  cloud.name = std::move(name);
  cloud.particles.mass.resize(n);
  for (double& mass : cloud.particles.mass) mass = random.log_uniform(lightest, heaviest);
  cloud.particles.pinned.assign(n, 0);
  cloud.state = {random_vector(random, 3 * n, 0.5), random_vector(random, 3 * n)};
  cloud.force = std::make_shared<CoupledForce>(random, n, stiffness, damping);
  return cloud;
}

Cloud chain(Random& random, int n, double mass, double stiff, double h) {
  Cloud cloud;
  cloud.name = "a chain of " + std::to_string(n);
  cloud.particles.mass.resize(n);
  for (double& value : cloud.particles.mass) value = mass * random.uniform(0.7, 1.4);
  cloud.particles.pinned.assign(n, 0);
  cloud.particles.pinned[0] = 1;
  cloud.state = {Eigen::VectorXd::Zero(3 * n), random_vector(random, 3 * n, 0.1)};
  cloud.state.v.head<3>().setZero();
  std::vector<particles::Spring> springs;
  Eigen::Vector3d along = Eigen::Vector3d(random_vector(random, 3)).normalized();
  for (int i = 1; i < n; ++i) {
    along += 0.3 * random_vector(random, 3);
    along.normalize();
    const double length = 0.01 * random.uniform(0.8, 1.2);
    cloud.state.x.segment<3>(3 * i) =
        cloud.state.x.segment<3>(3 * i - 3) + length * random.uniform(1, 1.001) * along;
    springs.push_back({i - 1, i, stiff * mass / (h * h), length});
  }
  cloud.force = std::make_shared<particles::DampedSprings>(std::move(springs), particles::Products::definite);
  return cloud;
}

Cloud in_other_units(const Cloud& cloud, double mass, double length) {
  Cloud other = cloud;
  other.name += ", in other units";
  other.particles.mass *= mass;
  other.state.x *= length;
  other.state.v *= length;
  other.force = std::make_shared<InOtherUnits>(cloud.force, mass, length);
  return other;
}

ImplicitSystem implicit_system(const Cloud& cloud, double a, double b) {
  const int size = 3 * cloud.count();
  const particles::State& state = cloud.state;
  ImplicitSystem system;
  system.A.setZero(size, size);
  for (int j = 0; j < size; ++j) {
    const Eigen::VectorXd e = Eigen::VectorXd::Unit(size, j);
    Eigen::VectorXd dfdx = Eigen::VectorXd::Zero(size), dfdv = dfdx;
    cloud.force->add_dfdx(state.x, state.v, e, dfdx);
    cloud.force->add_dfdv(state.x, state.v, e, dfdv);
    system.A.col(j) = -a * dfdv - a * b * dfdx;
    system.A(j, j) += cloud.particles.mass[j / 3];
  }
  Eigen::VectorXd f = Eigen::VectorXd::Zero(size), Kv = f;
  cloud.force->add_force(state.x, state.v, f);
  cloud.force->add_dfdx(state.x, state.v, state.v, Kv);
  system.rhs = a * (f + b * Kv);
  double in_rhs = kUnit * (size + 8) * a * (f.norm() + b * Kv.norm());
  for (int i = 0; i < cloud.count(); ++i) {
    if (!cloud.particles.is_pinned(i)) continue;
    system.A.middleRows<3>(3 * i).setZero();
    system.A.middleCols<3>(3 * i).setZero();
    system.rhs.segment<3>(3 * i).setZero();
  }
  system.norm = system.A.norm();
  for (int i = 0; i < cloud.count(); ++i)
    if (cloud.particles.is_pinned(i)) system.A.block<3, 3>(3 * i, 3 * i).setIdentity();
  const Eigen::LDLT<Eigen::MatrixXd> factors(system.A);
  system.dv = factors.solve(system.rhs);
  for (int i = 0; i < 2; ++i) system.dv += factors.solve(system.rhs - system.A * system.dv);
  system.smallest = solver::symmetric_eigenvalues(system.A).minCoeff();
  const double e = 2 * (size + 8), X = 2 * system.dv.norm() + system.rhs.norm();
  system.rounding = 65 * (10 + 2 * e) * kUnit * system.norm * X + in_rhs;
  return system;
}

}  // namespace grader::judge

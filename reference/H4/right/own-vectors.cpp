// STAFF ONLY. A right H4 with vectors of its own, particle by particle. It scales the right-hand side for
// ConjGrad to length 1.
#include "particles/implicit_euler.h"

#include <cmath>
#include <vector>

#include "particles/solve_implicit.h"

namespace {

using Numbers = std::vector<double>;
using View = Eigen::Map<Eigen::VectorXd>;

View view(Numbers& numbers) {
  return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

double length(particles::Input numbers) {
  double sum = 0;
  for (double number : numbers) sum = std::hypot(sum, number);
  return sum;
}

// (M - P (a D + a b K) P + (1 - P) (1 - M)) x, where P keeps free particles and sets pinned ones to 0.
class Projected : public implicitMatrix {
 public:
  Projected(const particles::Force& force, const particles::Particles& particles,
            const particles::State& state, double a, double b)
      : force_(&force), particles_(&particles), state_(&state), a_(a), b_(b) {}

  void matVecMult(double x[], double b[]) override {
    const int n = particles_->count();
    in_.assign(x, x + 3 * static_cast<std::size_t>(n));
    along_v_.assign(in_.size(), 0);
    along_x_.assign(in_.size(), 0);
    project(in_);
    force_->add_dfdv(state_->x, state_->v, view(in_), view(along_v_));
    force_->add_dfdx(state_->x, state_->v, view(in_), view(along_x_));
    project(along_v_);
    project(along_x_);
    for (int j = 3 * n - 1; j >= 0; --j) {
      const auto k = static_cast<std::size_t>(j);
      const double mass = particles_->is_pinned(j / 3) ? 1 : particles_->mass[j / 3];
      b[j] = mass * x[j] - a_ * (along_v_[k] + b_ * along_x_[k]);
    }
  }

 private:
  void project(Numbers& numbers) const {
    for (std::size_t k = 0; k < numbers.size(); ++k)
      if (particles_->is_pinned(static_cast<int>(k / 3))) numbers[k] = 0;
  }

  const particles::Force* force_;
  const particles::Particles* particles_;
  const particles::State* state_;
  double a_, b_;
  Numbers in_ = {}, along_v_ = {}, along_x_ = {};
};

}  // namespace

std::unique_ptr<implicitMatrix> particles::implicit_matrix(const Force& force, const Particles& particles,
                                                           const State& state, double a, double b) {
  return std::make_unique<Projected>(force, particles, state, a, b);
}

void particles::implicit_rhs(const Force& force, const Particles& particles, const State& state, double a,
                             double b, Output rhs) {
  rhs.fill(0);
  force.add_dfdx(state.x, state.v, state.v, rhs);
  for (double& number : rhs) number *= b;
  force.add_force(state.x, state.v, rhs);
  for (int j = 0; j < rhs.size(); ++j) rhs[j] *= particles.is_pinned(j / 3) ? 0 : a;
}

particles::SolveReport particles::solve_plain(implicitMatrix& matrix, Output rhs, double tolerance,
                                              int most_steps, Output dv) {
  SolveReport report;
  report.rhs = length(rhs);
  const double unit = report.rhs > 0 ? report.rhs : 1;
  Numbers direction(rhs.begin(), rhs.end());
  for (double& number : direction) number /= unit;
  report.steps = most_steps;
  const double left = ConjGrad(static_cast<int>(direction.size()), &matrix, dv.data(), direction.data(),
                               tolerance * tolerance, &report.steps);
  dv *= unit;
  report.residual = unit * std::sqrt(left);
  report.converged = std::sqrt(left) <= tolerance;
  return report;
}

particles::SolveReport particles::implicit_euler(const Force& force, const Particles& particles, double h,
                                                 double tolerance, State& state, Scratch scratch) {
  Numbers change(static_cast<std::size_t>(state.v.size()));
  const SolveReport report = solve_implicit(force, particles, state, h, h, tolerance, view(change), scratch);
  for (Eigen::Index j = 0; j < state.v.size(); ++j) {
    state.x[j] += h * (state.v[j] + change[static_cast<std::size_t>(j)]);
    state.v[j] += change[static_cast<std::size_t>(j)];
  }
  return report;
}

// STAFF ONLY. P1: hidden cases of the four integrators. Only a method's own category compares the values of
// its step, so that one wrong method does not fail them all.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "grader/judge/cases/linear_system.h"
#include "grader/judge/cases/random.h"
#include "grader/judge/cases/trial.h"
#include "particles/explicit_integrators.h"
#include "reference/P1/runs.h"

namespace grader::p1 {
namespace {

using Eigen::MatrixXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The suite serves three accelerations: a linear one, a coupled one, an uncoupled one.

// a = -omega^2 x.
class Oscillator : public particles::Dynamics {
 public:
  explicit Oscillator(double omega) : omega_(omega) {}
  void acceleration(particles::Input x, particles::Input /*v*/, particles::Output a) override {
    a = -omega_ * omega_ * x;
  }

 private:
  double omega_;
};

// a = A sin(x) + B sin(v), entry by entry: nonlinear, and every entry depends on all others. Pinned particles
// have rows of zeros.
class Waves : public particles::Dynamics {
 public:
  Waves(Random& random, int n) : A(3 * n, 3 * n), B(3 * n, 3 * n) {
    for (MatrixXd* matrix : {&A, &B})
      for (double& entry : matrix->reshaped()) entry = random.normal() / std::sqrt(3 * n);
  }
  void pin(int i) { A.middleRows(3 * i, 3).setZero(), B.middleRows(3 * i, 3).setZero(); }

  void acceleration(particles::Input x, particles::Input v, particles::Output a) override {
    a = A * x.array().sin().matrix() + B * v.array().sin().matrix();
  }

  MatrixXd A, B;
};

// a = -c sin(x), with its own c for each coordinate of a particle: uncoupled, and reversible in time.
class Pendulums : public particles::Dynamics {
 public:
  explicit Pendulums(Random& random) {
    for (double& strength : strength_) strength = random.uniform(0.5, 2);
  }
  void acceleration(particles::Input x, particles::Input /*v*/, particles::Output a) override {
    for (Eigen::Index i = 0; i < x.size(); ++i) a[i] = -strength_[i % 3] * std::sin(x[i]);
  }

 private:
  Eigen::Vector3d strength_;
};

bool same_vectors(const VectorXd& a, const VectorXd& b) {
  return same_bits({a.begin(), a.end()}, {b.begin(), b.end()});
}

// The error of (x, v / omega) at t = 2 / omega, for steps of h omega = 2 / steps: the sine is 0.91 there.
double oscillator_error(Trial& trial, const Method& method, double omega, const State& start, int steps) {
  Oscillator oscillator(omega);
  const State end = run(trial, method, oscillator, start, {2 / omega / steps, steps}).end();
  const VectorXd x = std::cos(2) * start.x + std::sin(2) * start.v / omega;
  const VectorXd v = std::cos(2) * start.v - std::sin(2) * omega * start.x;
  return std::hypot((end.x - x).norm(), (end.v - v).norm() / omega);
}

// The error is C h^p (1 + c h omega + ...). From 16 to 32 steps log2 of its ratio is p + 0.09 c; the methods'
// c is at most 1.2 in size at omega t = 2, and 0.25 tells any two orders apart.
void expect_order(Trial& trial, const Method& method, double omega, State start) {
  start.v *= omega;
  const double error = oscillator_error(trial, method, omega, start, 16);
  const double order = std::log2(error / oscillator_error(trial, method, omega, start, 32));
  trial.expect(std::abs(order - method.order) <= 0.25,
               std::string("the observed order of ") + method.name + " on an oscillator is not its order",
               std::to_string(order));
}

// Compares one step with the reference's. With z = (x, v) and seconds as the unit, z' = (v, a) has the
// Lipschitz constant L <= 1 + ||A|| + ||B||. A stage or the last sum has at most 8 roundings of terms that
// are at most ||z|| + h ||z'||, and an acceleration rounds by 6n + 4 in u of its terms' sum, (||A|| + ||B||)
// sqrt(3n). Up to three stages after it multiply that by 1 + h L each. Both sides round, so the bound is
// twice that.
void expect_reference_step(Trial& trial, const Method& method, Waves& waves, const State& start, double h) {
  const int size = static_cast<int>(start.x.size());
  const Run student = run(trial, method, waves, start, {h});
  State expected = start;
  MatrixXd scratch(size, particles::kIntegratorScratch);
  method.reference(waves, h, expected.x, expected.v, scratch);

  const double strength = waves.A.norm() + waves.B.norm(), largest = strength * std::sqrt(size);
  const double z = std::hypot(start.x.norm(), start.v.norm());
  const double bound = 2 * kUnit * std::pow(1 + h * (1 + strength), 3) *
                       (8 * (z + h * (z + largest)) + h * (2 * size + 4) * largest);
  const std::string step = std::string(" after one step of ") + method.name;
  trial.expect_close({student.end().x, expected.x, 3, start.x}, bound, "the error of x" + step);
  trial.expect_close({student.end().v, expected.v, 3, start.v}, bound, "the error of v" + step);
}

// A step is compared first, since wrong numbers show more than a wrong order.
void expect_method(Trial& trial, const Method& method) {
  const double omega = trial.random.log_uniform(0.1, 100);
  const State swinging = random_state(trial.random, 2);
  for (int n : {1, 2, 5, 12})
    for (bool pinned : {false, true}) {
      Waves waves(trial.random, n);
      if (pinned) waves.pin(trial.random.integer(0, n - 1));
      const State start = random_state(trial.random, n);
      expect_reference_step(trial, method, waves, start, trial.random.log_uniform(1e-2, 1));
    }
  expect_order(trial, method, omega, swinging);
}

// With s = h omega and w = omega x, the method keeps v^2 + w^2 - s v w of each coordinate, which lies between
// 1 - s/2 and 1 + s/2 times v^2 + w^2. Rounding adds at most some 10 u a step.
void expect_energy_stays(Trial& trial) {
  for (double s : {0.1, 0.5, 1.0, trial.random.uniform(1.2, 1.8)}) {
    const double omega = trial.random.log_uniform(0.1, 100), h = s / omega;
    State start = random_state(trial.random, 1);
    start.v *= omega;
    Oscillator oscillator(omega);
    const int steps = 300;
    const Run student = run(trial, kMethods[1], oscillator, start, {h, steps});
    for (int i = 0; i < 3; ++i) {
      double least = kInfinity, most = 0;
      int turns = 0;  // passes through 0
      double before = start.x[i];
      for (const State& state : student.states) {
        const double energy = std::pow(state.v[i], 2) + std::pow(omega * state.x[i], 2);
        trial.expect(std::isfinite(energy), "the energy of an oscillator is not finite");
        least = std::min(least, energy);
        most = std::max(most, energy);
        turns += (before < 0) != (state.x[i] < 0);
        before = state.x[i];
      }
      const double promised = (1 + s / 2) / (1 - s / 2);
      trial.expect_at_most(most / least, {promised, 1e-12 * promised},
                           "the ratio of an oscillator's largest energy to its least");
      // It turns by 2 asin(s/2) a step.
      trial.expect(std::abs(turns - steps * 2 * std::asin(s / 2) / std::numbers::pi) <= 2,
                   "an oscillator does not swing as often as it should", std::to_string(turns));
    }
  }
}

}  // namespace

void forward_euler(Trial& trial) {
  expect_method(trial, kMethods[0]);
}

void symplectic_euler(Trial& trial) {
  expect_method(trial, kMethods[1]);
  expect_energy_stays(trial);
}

void midpoint(Trial& trial) {
  expect_method(trial, kMethods[2]);
}

void runge_kutta_4(Trial& trial) {
  expect_method(trial, kMethods[3]);
}

namespace {

// The methods that other categories can use: their step moves the particles, and repeats with the same
// result. One wrong method loses only its own category. If more are wrong, little is left to check.
std::vector<const Method*> usable_methods(Trial& trial) {
  std::vector<const Method*> usable;
  Pendulums pendulums(trial.random);
  const double h = trial.random.log_uniform(1e-3, 1e-2);
  const State one = random_state(trial.random, 1), other = random_state(trial.random, 1);
  for (const Method& method : kMethods) {
    const State moved = run(trial, method, pendulums, one, {h}).end();
    run(trial, method, pendulums, other, {h});
    const State again = run(trial, method, pendulums, one, {h}).end();
    const bool moves = (moved.x - one.x - h * one.v).norm() <= 0.5 * (h * one.v).norm() && moved.v != one.v &&
                       moved.v.allFinite();
    if (moves && same_vectors(moved.x, again.x) && same_vectors(moved.v, again.v)) usable.push_back(&method);
  }
  trial.require(usable.size() + 1 >= std::size(kMethods),
                "two or more methods move particles by something else than about h v, or give another result "
                "for the same "
                "call");
  return usable;
}

}  // namespace

void evaluations(Trial& trial) {
  for (const Method* method : usable_methods(trial))
    for (int n : {1, 4}) {
      Waves waves(trial.random, n);
      const int steps = trial.random.integer(2, 6);
      const Run student = run(trial, *method, waves, random_state(trial.random, n), {1e-3, steps});
      trial.expect(student.evaluations == steps * method->evaluations,
                   std::string("the number of evaluations of ") + method->name + " is not the contract's",
                   std::to_string(student.evaluations) + " in " + std::to_string(steps) + " steps");
    }
}

// If a depends on x alone, a step of -h from (x, v) equals a step of h from (x, -v) with the velocity turned
// around, bit by bit, for the four methods and for most wrong ones.
void either_sign(Trial& trial) {
  for (const Method* method : usable_methods(trial))
    for (int n : {1, 3}) {
      Pendulums pendulums(trial.random);
      const State start = random_state(trial.random, n), turned{start.x, -start.v};
      const double h = trial.random.log_uniform(1e-3, 1e-2);
      const State forwards = run(trial, *method, pendulums, turned, {h}).end(),
                  backwards = run(trial, *method, pendulums, start, {-h}).end();
      trial.expect((backwards.x - forwards.x).norm() <= 16 * kUnit * start.x.norm() &&
                       (backwards.v + forwards.v).norm() <= 16 * kUnit * start.v.norm(),
                   std::string(method->name) + " with a negative h does not go back in time");
      const State still = run(trial, *method, pendulums, start, {0.0}).end();
      trial.expect(still.x == start.x && still.v == start.v,
                   std::string(method->name) + " with h = 0 changes the state");
    }
}

// Equal particles move equally, one of them or a thousand. A linear force has no unit of its own, and
// powers of two round nothing.
void sizes_and_units(Trial& trial) {
  for (const Method* method : usable_methods(trial)) {
    Pendulums pendulums(trial.random);
    const double h = trial.random.log_uniform(1e-3, 1e-2);
    const State one = random_state(trial.random, 1);
    run(trial, *method, pendulums, {VectorXd(0), VectorXd(0)}, {h});
    const State moved = run(trial, *method, pendulums, one, {h}).end();
    for (int n : {2, 30, 1000}) {
      const State alike{one.x.replicate(n, 1), one.v.replicate(n, 1)};
      const State end = run(trial, *method, pendulums, alike, {h}).end();
      trial.expect(
          (end.x - moved.x.replicate(n, 1)).lpNorm<Eigen::Infinity>() <= 16 * kUnit * one.x.norm() &&
              (end.v - moved.v.replicate(n, 1)).lpNorm<Eigen::Infinity>() <= 16 * kUnit * one.v.norm(),
          std::string(method->name) + " moves particles that are alike in different ways");
    }
    Oscillator oscillator(trial.random.uniform(1, 2));
    const State swung = run(trial, *method, oscillator, one, {h}).end();
    for (double unit : {0x1p-100, 0x1p100}) {
      const State end = run(trial, *method, oscillator, {unit * one.x, unit * one.v}, {h}).end();
      trial.expect(end.x == unit * swung.x && end.v == unit * swung.v,
                   std::string(method->name) + " does other things in another unit of length");
    }
  }
}

// The content of scratch and earlier calls change nothing. (In the other categories scratch holds zeros.)
void scratch_memory(Trial& trial) {
  int moving = 0;
  for (const Method& method : kMethods) {
    Pendulums pendulums(trial.random);
    const double h = trial.random.log_uniform(1e-3, 1e-2);
    const State one = random_state(trial.random, 1);
    run(trial, method, pendulums, random_state(trial.random, 1), {h});
    const State moved = run(trial, method, pendulums, one, {h}).end();
    moving += moved.x != one.x && moved.v != one.v;
    for (const Filling& filling : {Filling{0, 0}, {0, 1e300}, {0, kInfinity}, {3, kUnset}}) {
      const State again = run(trial, method, pendulums, one, {h, 1, filling}).end();
      trial.expect(same_vectors(again.x, moved.x) && same_vectors(again.v, moved.v),
                   std::string(method.name) + " depends on what scratch holds, or on the call before");
    }
  }
  trial.expect(moving + 1 >= static_cast<int>(std::size(kMethods)), "the methods do not move the particles");
}

// With h omega = 1e6 an oscillator grows at least by 1e6 a step, and overflows within 60.
void blow_up(Trial& trial) {
  const int steps = 60;
  for (const Method* method : usable_methods(trial)) {
    const double omega = trial.random.log_uniform(0.1, 100);
    Oscillator oscillator(omega);
    const State start = random_state(trial.random, 2);
    const Run student = run(trial, *method, oscillator, start, {1e6 / omega, steps});
    trial.expect(student.states[4].x.allFinite() && student.states[4].v.allFinite(),
                 std::string(method->name) + " gives values that are not finite before they overflow");
    trial.expect(!(student.end().x.allFinite() && student.end().v.allFinite()),
                 std::string(method->name) + " hides that the values have overflowed");
  }
}

}  // namespace grader::p1

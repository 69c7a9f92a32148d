#include "hair/lab/validate/chain_methods.h"

#include <cmath>

#include "hair/lab/validate/dispersion.h"
#include "hair/simulation/simulation.h"
#include "particles/toys/moving_toy.h"

namespace hair {

namespace {

using particles::MovingToy, particles::Toy, particles::ToyMethod, particles::ToyStep;

constexpr double kSolves = 1e-12;

Eigen::VectorXd masses_with_hinge(const HangingChain& chain) {
  Eigen::VectorXd mass(chain.count() + 1);
  mass << chain.mass[0], chain.mass;  // the hinge is held: its mass does not matter
  return mass;
}

class MassSpringChain : public MovingChain {
 public:
  MassSpringChain(const HangingChain& chain, const particles::State& state, double step)
      : simulation_(describe(chain, state, step)) {}
  void step() override { simulation_.step(); }
  const particles::State& state() const override { return simulation_.state(0); }

 private:
  static Description describe(const HangingChain& chain, const particles::State& state, double step) {
    Strand strand;
    strand.mass = masses_with_hinge(chain);
    strand.rest_length = Eigen::VectorXd::Constant(chain.count(), chain.link);
    strand.stretch_rigidity = chain.tension(0) / chain.stretch;
    Description description;
    description.strands = {{strand, state}};
    description.method = Method::predictor_corrector;
    description.step = step;
    description.gravity = Vector3d(0, 0, -chain.gravity);
    description.tolerance = kSolves;
    return description;
  }

  Simulation simulation_;
};

class ChainOfRods : public MovingChain {
 public:
  ChainOfRods(const HangingChain& chain, const particles::State& state, double step)
      : toy_(describe(chain, state)),
        step_(particles::toy_step_of(ToyMethod::runge_kutta_4)),
        options_{step, 0},
        scratch_(state.x.size(), step_.scratch) {}
  void step() override { step_.step(toy_, options_, scratch_); }
  const particles::State& state() const override { return toy_.state; }

 private:
  static Toy describe(const HangingChain& chain, const particles::State& state) {
    Toy toy;
    toy.particles = {masses_with_hinge(chain), std::vector<char>(chain.count() + 1, 0)};
    toy.particles.pinned[0] = 1;
    toy.start = state;
    for (int i = 0; i < chain.count(); ++i) toy.constraints.rods.push_back({i, i + 1, chain.link});
    toy.gravity = Vector3d(0, 0, -chain.gravity);
    return toy;
  }

  MovingToy toy_;
  ToyStep step_;
  StepOptions options_;
  Eigen::MatrixXd scratch_;
};

// The error from stretching, see dispersion.h.
double h6_error(const HangingChain& chain, double x) {
  return chain.count() * chain.stretch * x / 4;
}

// Up to n s x / 2, see dispersion.h: the middle of this range, with half the range as the error.
double h6_decay(const HangingChain& chain, double x, double) {
  return chain.count() * chain.stretch * x / 4;
}

// P2 solves to r = 1e-10 of a right-hand side that is l g. The inverse of J W J^T has the entries sum_{k >=
// max(i,j)} m_k / l^2, so the tension is off by at most n (T_0 / g) r / l, and w by half of that relative to
// the smallest tension.
double rods_error(const HangingChain& chain, double) {
  return 1e-10 * chain.count() * chain.tension(0) / chain.tension(chain.count() - 1) / 2;
}

double rods_decay(const HangingChain&, double, double turn) {
  return runge_kutta_4_decay(turn);
}

// A force's relative error, twice that of w, changes the speed by that part of `turn` of the amplitude.
double rods_decay_error(const HangingChain& chain, double x, double turn) {
  return 2 * rods_error(chain, x) * turn;
}

template <class Chain>
std::unique_ptr<MovingChain> start(const HangingChain& chain, const particles::State& state, double step) {
  return std::make_unique<Chain>(chain, state, step);
}

}  // namespace

const ChainMethod& chain_by_h6() {
  static const ChainMethod method{"h6",     "mass-spring, H6", {"S1", "H1", "H4", "H5", "H6"},
                                  1,        undo_leapfrog,     h6_error,
                                  h6_decay, h6_decay,          start<MassSpringChain>};
  return method;
}

const ChainMethod& chain_by_rods() {
  static const ChainMethod method{"rods",
                                  "rods of P2, Runge-Kutta 4",
                                  {"S1", "P1", "P2"},
                                  4,
                                  undo_runge_kutta_4,
                                  rods_error,
                                  rods_decay,
                                  rods_decay_error,
                                  start<ChainOfRods>};
  return method;
}

particles::State turned(const HangingChain& chain, const Eigen::VectorXd& angles) {
  const int n = chain.count();
  particles::State state{Eigen::VectorXd::Zero(3 * n + 3), Eigen::VectorXd::Zero(3 * n + 3)};
  for (int i = 0; i < n; ++i)
    state.x.segment<3>(3 * i + 3) =
        state.x.segment<3>(3 * i) + chain.link * Vector3d(std::sin(angles[i]), 0, -std::cos(angles[i]));
  return state;
}

}  // namespace hair

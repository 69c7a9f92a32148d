#include "hair/lab/validate/chain_methods.h"

#include <cmath>

#include "hair/lab/validate/dispersion.h"

namespace hair {

namespace {

Eigen::VectorXd masses_with_hinge(const HangingChain& chain) {
  Eigen::VectorXd mass(chain.count() + 1);
  mass << chain.mass[0], chain.mass;  // the hinge is held: its mass does not matter
  return mass;
}

Scene scene_of(const HangingChain& chain, double step) {
  Scene scene;
  scene.steps_per_frame = 1;
  scene.frames_per_second = 1 / step;
  scene.hair.method = Method::predictor_corrector;
  scene.hair.step = step;
  scene.hair.gravity = Vector3d(0, 0, -chain.gravity);
  scene.hair.tolerance = 1e-12;
  scene.hair.watched = false;
  return scene;
}

Scene springs_of(const HangingChain& chain, const particles::State& state, double step) {
  Strand strand;
  strand.mass = masses_with_hinge(chain);
  strand.rest_length = Eigen::VectorXd::Constant(chain.count(), chain.link);
  strand.stretch_rigidity = chain.tension(0) / chain.stretch;
  Scene scene = scene_of(chain, step);
  scene.hair.strands = {{strand, state}};
  return scene;
}

Scene rods_of(const HangingChain& chain, const particles::State& state, double step) {
  Scene scene = scene_of(chain, step);
  Toy& toy = scene.toys.emplace_back();
  toy.particles = {masses_with_hinge(chain), std::vector<char>(chain.count() + 1, 0)};
  toy.particles.pinned[0] = 1;
  toy.start = state;
  toy.method = ToyMethod::runge_kutta_4;
  for (int i = 0; i < chain.count(); ++i) toy.constraints.rods.push_back({i, i + 1, chain.link});
  toy.gravity = scene.hair.gravity;
  return scene;
}

// The error from stretching; and the decay, which is up to n s x / 2: the middle of this range, with half the
// range as its error. See dispersion.h.
double of_stretch(const HangingChain& chain, double x, double) {
  return chain.count() * chain.stretch * x / 4;
}

// P2 solves to r = 1e-10 of a right-hand side that is l g. The inverse of J W J^T has the entries sum_{k >=
// max(i,j)} m_k / l^2, so the tension is off by at most n (T_0 / g) r / l, and w by half of that relative to
// the smallest tension.
double rods_error(const HangingChain& chain, double, double) {
  return 1e-10 * chain.count() * chain.tension(0) / chain.tension(chain.count() - 1) / 2;
}

double rods_decay(const HangingChain&, double, double turn) {
  return runge_kutta_4_decay(turn);
}

// A force's relative error, twice that of w, changes the speed by that part of `turn` of the amplitude.
double rods_decay_error(const HangingChain& chain, double x, double turn) {
  return 2 * rods_error(chain, x, turn) * turn;
}

}  // namespace

const ChainMethod& chain_by_h6() {
  static const ChainMethod method{"h6",       "mass-spring, H6", {"S1", "H1", "H4", "H5", "H6"},
                                  1,          undo_leapfrog,     of_stretch,
                                  of_stretch, of_stretch,        springs_of};
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
                                  rods_of};
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

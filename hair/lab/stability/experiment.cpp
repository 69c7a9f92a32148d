#include "hair/lab/stability/experiment.h"

#include <algorithm>
#include <cmath>

namespace hair {

namespace {

// Energies of the modes in one direction, J, for positions relative to those at rest.
Eigen::VectorXd energies_in(const Modes& modes, const Hanging& hanging, const particles::State& state,
                            const Vector3d& direction) {
  const Eigen::Index n = hanging.mass.size();
  Eigen::VectorXd x(n), v(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    x[i] = direction.dot(state.x.segment<3>(3 * i + 3) - hanging.start.state.x.segment<3>(3 * i + 3));
    v[i] = direction.dot(state.v.segment<3>(3 * i + 3));
  }
  const Eigen::MatrixXd to_modes = modes.shape.transpose() * hanging.mass.asDiagonal();
  const Eigen::ArrayXd p = (to_modes * x).array() * modes.omega.array(), q = to_modes * v;
  return (p.square() + q.square()) / 2;
}

}  // namespace

const char* fate_name(Fate fate) {
  constexpr const char* kNames[kFates] = {"stable", "damped out", "wrong", "blown up"};
  return kNames[static_cast<int>(fate)];
}

double oscillator_energy(double omega, double gamma, double t) {
  // From x = 0, v = 1. Written so that nothing overflows.
  const double half = gamma / 2, discriminant = half * half - omega * omega;
  const double w = std::sqrt(std::abs(discriminant));
  double x, v;
  if (w * t < 1e-6) {  // critical, or the start: sin(wt)/w and sinh(wt)/w are t
    x = t * std::exp(-half * t);
    v = (1 - half * t) * std::exp(-half * t);
  } else if (discriminant < 0) {
    x = std::exp(-half * t) * std::sin(w * t) / w;
    v = std::exp(-half * t) * std::cos(w * t) - half * x;
  } else {
    // With strong drag the slow root, -half + w, loses its digits: it is -omega^2 / (half + w).
    const double fast = -half - w, slow = -omega * omega / (half + w);
    const double e_fast = std::exp(fast * t), e_slow = std::exp(slow * t);
    x = (e_slow - e_fast) / (2 * w);
    v = (slow * e_slow - fast * e_fast) / (2 * w);
  }
  return v * v + omega * omega * x * x;
}

bool Judge::look(const Eigen::VectorXd& energies, double kinetic, double true_mean) {
  const double largest = energies.maxCoeff(), mean = energies.mean();
  if (!(kinetic <= 1) || !std::isfinite(mean)) {
    broke();
    return true;
  }
  outcome_.growth = std::max(outcome_.growth, largest);
  if (largest > kWrongGrowth) outcome_.fate = Fate::wrong;
  if (true_mean < kStillThere) return false;
  outcome_.kept = mean / true_mean;
  if (outcome_.kept < kLostEnergy && outcome_.fate == Fate::stable) outcome_.fate = Fate::damped_out;
  return false;
}

Outcome run_disturbed(const Description& hair, const Hanging& hanging, const Disturbance& disturbance,
                      double drag, double h, long steps) {
  Description description = hair;
  description.strands = {hanging.start};
  description.strands[0].state = disturbance.state;
  description.obstacles.clear();
  description.wind.setZero();
  description.drag = drag;
  description.step = h;
  Simulation simulation(std::move(description));

  const Strand& strand = hanging.start.strand;
  const double disturbed = disturbance.energy_of_mode * disturbance.modes;
  const double most_kinetic =
      std::max(2 * strand.mass.sum() * hair.gravity.norm() * strand.rest_length.sum(), 1e6 * disturbed);
  const double gamma = hanging.drag_per_mass * drag;
  const Eigen::Index n = hanging.mass.size();
  Eigen::VectorXd energies(disturbance.modes);
  Judge judge;
  for (int k = 1; k <= kLooks; ++k) {
    if (simulation.advance(steps * k / kLooks - simulation.steps())) {
      judge.broke();
      break;
    }
    const particles::State& state = simulation.state(0);
    double kinetic = 0, true_mean = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      kinetic += hanging.mass[i] * state.v.segment<3>(3 * i + 3).squaredNorm() / 2;
    const auto add = [&](const Modes& modes, const Vector3d& direction, Eigen::Index from) {
      energies.segment(from, n) = energies_in(modes, hanging, state, direction) / disturbance.energy_of_mode;
      for (const double omega : modes.omega) true_mean += oscillator_energy(omega, gamma, simulation.time());
    };
    add(hanging.across_modes, hanging.across, 0);
    if (!hanging.keeps_lengths) add(hanging.along_modes, hanging.down, n);
    if (judge.look(energies, kinetic / most_kinetic, true_mean / disturbance.modes)) break;
  }
  Outcome outcome = judge.outcome();
  outcome.steps = simulation.steps();
  return outcome;
}

}  // namespace hair

// STAFF ONLY. A right P1 with vectors of its own: a state and its derivative as pairs, and a step along one.
#include "particles/explicit_integrators.h"

#include <vector>

namespace {

using particles::Dynamics;
using particles::Output;

using Numbers = std::vector<double>;

// A state, or its derivative: (x, v) or (v, a).
struct Pair {
  Numbers first, second;
};

Pair read(const Output& x, const Output& v) {
  return {Numbers(x.data(), x.data() + x.size()), Numbers(v.data(), v.data() + v.size())};
}

void write(const Pair& state, Output& x, Output& v) {
  for (std::size_t i = 0; i < state.first.size(); ++i) {
    x[static_cast<int>(i)] = state.first[i];
    v[static_cast<int>(i)] = state.second[i];
  }
}

Pair slope(Dynamics& dynamics, const Pair& state) {
  const int size = static_cast<int>(state.first.size());
  Pair result{state.second, Numbers(state.first.size())};
  dynamics.acceleration(Eigen::Map<const Eigen::VectorXd>(state.first.data(), size),
                        Eigen::Map<const Eigen::VectorXd>(state.second.data(), size),
                        Eigen::Map<Eigen::VectorXd>(result.second.data(), size));
  return result;
}

Pair along(Pair state, double time, const Pair& direction) {
  for (std::size_t i = 0; i < state.first.size(); ++i) {
    state.first[i] += time * direction.first[i];
    state.second[i] += time * direction.second[i];
  }
  return state;
}

}  // namespace

namespace particles {

void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch) {
  const Pair start = read(x, v);
  write(along(start, h, slope(dynamics, start)), x, v);
}

void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch) {
  const Pair start = read(x, v);
  Pair derivative = slope(dynamics, start);
  for (std::size_t i = 0; i < derivative.first.size(); ++i)
    derivative.first[i] = start.second[i] + h * derivative.second[i];
  write(along(start, h, derivative), x, v);
}

void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch) {
  const Pair start = read(x, v), middle = along(start, 0.5 * h, slope(dynamics, start));
  write(along(start, h, slope(dynamics, middle)), x, v);
}

void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch) {
  const Pair start = read(x, v), k1 = slope(dynamics, start), k2 = slope(dynamics, along(start, h / 2, k1)),
             k3 = slope(dynamics, along(start, h / 2, k2)), k4 = slope(dynamics, along(start, h, k3));
  write(along(along(along(along(start, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4), x, v);
}

}  // namespace particles

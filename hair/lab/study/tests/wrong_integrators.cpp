// STAFF ONLY. Typical wrong versions of P1: a midpoint that moves particles by the start's velocity, and an
// RK4 whose accelerations are 1 % off. Forward and symplectic Euler are right.
#include "particles/explicit_integrators.h"

namespace particles {

void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  dynamics.acceleration(x, v, scratch.col(0));
  x += h * v;
  v += h * scratch.col(0);
}

void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  dynamics.acceleration(x, v, scratch.col(0));
  v += h * scratch.col(0);
  x += h * v;
}

void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  scratch.col(1) = x + h / 2 * v;
  scratch.col(2) = v;
  dynamics.acceleration(scratch.col(1), scratch.col(2), scratch.col(0));
  x += h * v;
  v += h * scratch.col(0);
}

void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  const auto slope = [&](int stage, double time, int before) {
    if (stage == 0) {
      scratch.col(8) = x;
      scratch.col(0) = v;
    } else {
      scratch.col(8) = x + time * scratch.col(before);
      scratch.col(stage) = v + time * scratch.col(4 + before);
    }
    dynamics.acceleration(scratch.col(8), scratch.col(stage), scratch.col(4 + stage));
    scratch.col(4 + stage) *= 1.01;
  };
  slope(0, 0, 0);
  slope(1, h / 2, 0);
  slope(2, h / 2, 1);
  slope(3, h, 2);
  x += h / 6 * (scratch.col(0) + 2 * scratch.col(1) + 2 * scratch.col(2) + scratch.col(3));
  v += h / 6 * (scratch.col(4) + 2 * scratch.col(5) + 2 * scratch.col(6) + scratch.col(7));
}

}  // namespace particles

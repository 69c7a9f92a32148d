// STAFF ONLY. A right P1, slope by slope. The patches for P1 apply to it.
#include "particles/explicit_integrators.h"

namespace particles {

void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  auto a = scratch.col(0);
  dynamics.acceleration(x, v, a);
  x += h * v;
  v += h * a;
}

void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  auto a = scratch.col(0);
  dynamics.acceleration(x, v, a);
  v += h * a;
  x += h * v;
}

void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  auto a1 = scratch.col(0), x2 = scratch.col(1), v2 = scratch.col(2), a2 = scratch.col(3);
  dynamics.acceleration(x, v, a1);
  x2 = x + h / 2 * v;
  v2 = v + h / 2 * a1;
  dynamics.acceleration(x2, v2, a2);
  x += h * v2;
  v += h * a2;
}

void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  auto a1 = scratch.col(0), a2 = scratch.col(1), a3 = scratch.col(2), a4 = scratch.col(3);
  auto v2 = scratch.col(4), v3 = scratch.col(5), v4 = scratch.col(6), xs = scratch.col(7);

  dynamics.acceleration(x, v, a1);

  xs = x + h / 2 * v;
  v2 = v + h / 2 * a1;
  dynamics.acceleration(xs, v2, a2);

  xs = x + h / 2 * v2;
  v3 = v + h / 2 * a2;
  dynamics.acceleration(xs, v3, a3);

  xs = x + h * v3;
  v4 = v + h * a3;
  dynamics.acceleration(xs, v4, a4);

  x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

}  // namespace particles

// STAFF ONLY. P1: explicit integrators. The contract is in particles/explicit_integrators.h.

#include "particles/explicit_integrators.h"

namespace particles {

void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  Output a = scratch.col(0);
  dynamics.acceleration(x, v, a);
  x += h * v;
  v += h * a;
}

void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  Output a = scratch.col(0);
  dynamics.acceleration(x, v, a);
  v += h * a;
  x += h * v;
}

void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  Output a = scratch.col(0), x_mid = scratch.col(1), v_mid = scratch.col(2);
  dynamics.acceleration(x, v, a);
  x_mid = x + 0.5 * h * v;
  v_mid = v + 0.5 * h * a;
  dynamics.acceleration(x_mid, v_mid, a);
  x += h * v_mid;
  v += h * a;
}

void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  Output x_stage = scratch.col(0), v_stage = scratch.col(1), a = scratch.col(2);
  Output dx = scratch.col(3), dv = scratch.col(4);  // slopes, summed up with their weights

  // Goes `time` seconds from x, v along the slope v_stage, a, and finds the slope there. One sweep through
  // the memory is faster than one for each line.
  const auto next_slope = [&](double time, double weight) {
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      x_stage[k] = x[k] + time * v_stage[k];
      v_stage[k] = v[k] + time * a[k];
    }
    dynamics.acceleration(x_stage, v_stage, a);
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      dx[k] += weight * v_stage[k];
      dv[k] += weight * a[k];
    }
  };

  v_stage = v;
  dynamics.acceleration(x, v, a);
  dx = v_stage;
  dv = a;
  next_slope(h / 2, 2);
  next_slope(h / 2, 2);
  next_slope(h, 1);

  x += h / 6 * dx;
  v += h / 6 * dv;
}

}  // namespace particles

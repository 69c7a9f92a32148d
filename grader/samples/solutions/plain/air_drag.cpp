// STAFF ONLY. X1, entry by entry.
#include "particles/air_drag.h"

#include <cmath>

void particles::add_air_drag(double coefficient, Input wind, Input v, Output f) {
  for (int i = 0; 3 * i < v.size(); i++) {
    double u[3];
    for (int k = 0; k < 3; k++) u[k] = wind[3 * i + k] - v[3 * i + k];
    const double size = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    for (int k = 0; k < 3; k++) f[3 * i + k] += coefficient * size * u[k];
  }
}

#include "hair/lab/validate/dispersion.h"

#include <cmath>

namespace hair {

double undo_leapfrog(double measured, double step) {
  return 2 / step * std::sin(measured * step / 2);
}

double undo_runge_kutta_4(double measured, double step) {
  double y = measured * step;
  for (int i = 0; i < 20; ++i) {
    const double sine = y - y * y * y / 6, cosine = 1 - y * y / 2 + y * y * y * y / 24;
    // d sine = 1 - y^2/2, d cosine = -sine
    const double slope = ((1 - y * y / 2) * cosine + sine * sine) / (sine * sine + cosine * cosine);
    y -= (std::atan2(sine, cosine) - measured * step) / slope;
  }
  return y / step;
}

double runge_kutta_4_decay(double y) {
  const double square = y * y;
  return -std::log1p(square * square * square * (square / 576 - 1.0 / 72)) / 2;
}

double undo_implicit_euler(double measured, double step) {
  return std::tan(measured * step) / step;
}

double undo_filters(double measured, double step) {
  const double sine = std::sin(measured * step / 2);  // 1 / cos - 1 = 2 sine^2 / cos, without a difference
  return 2 * sine / std::sqrt(std::cos(measured * step)) / step;
}

}  // namespace hair

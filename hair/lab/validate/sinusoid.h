// The one sinusoid in a signal, and what an integrator's own dispersion makes of a frequency.
#pragma once

#include <Eigen/Core>

namespace hair {

struct Sinusoid {
  double frequency = 0;  // rad for each sample; NaN, if there is none, or the fit does not converge
  double decay = 0;      // of the amplitude, for each sample
  double amplitude = 0;
  double residual = 0;  // root of the mean square of what is left
};

// Fits exp(-decay k) (a cos(frequency k) + b sin(frequency k)) to samples k = 0, 1, ... by least squares:
// Gauss and Newton's method, from the frequency at which the signal changes its sign. It must do so three
// times or more.
Sinusoid fit_sinusoid(const Eigen::VectorXd& samples);

}  // namespace hair

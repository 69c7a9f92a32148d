// Fits a sinusoid to a signal.
#pragma once

#include <Eigen/Core>

namespace hair {

struct Sinusoid {
  double frequency = 0;  // rad for each sample; NaN if there is none or the fit does not converge
  double decay = 0;      // the amplitude's, for each sample
  double amplitude = 0;
  double residual = 0;  // root mean square of signal minus fit
};

// Fits exp(-decay k) (a cos(frequency k) + b sin(frequency k)) to samples k = 0, 1, ... by least squares with
// the Gauss-Newton method. The first guess of the frequency comes from the signal's sign changes; it must
// have at least three.
Sinusoid fit_sinusoid(const Eigen::VectorXd& samples);

}  // namespace hair

// Hair that moves until drag has brought it to rest.
#pragma once

#include "hair/lab/validate/validation.h"
#include "hair/simulation/simulation.h"

namespace hair {

struct Settled {
  Eigen::VectorXd x;  // NaN, if it broke on the way
  double speed = 0;   // m/s, of the fastest particle, at the end
  double cpu_seconds = 0;
};

// With drag that is critical for an oscillation of `slowest` rad/s = w, so that all that are faster decay
// like exp(-w t); for 60 / w seconds. H4 and H6 damp by themselves: an oscillation w by w^2 h, which makes
// the slowest one creep, at w (1 + d - sqrt(2 d + d^2)), d = w h / 2; half of w is left at w h = 0.5, and of
// what was to decay 1e-13. Where nothing is slowest (NaN) it does not move at all, and counts as broken.
Settled settle(const StrandStart& start, const Material& material, Method method, double slowest, double step,
               const ValidationSettings& settings);

}  // namespace hair

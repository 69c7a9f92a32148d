// Moves hair until drag brings it to rest.
#pragma once

#include "hair/lab/validate/validation.h"
#include "hair/simulation/simulation.h"

namespace hair {

struct Settled {
  Eigen::VectorXd x;  // NaN if the run broke
  double speed = 0;   // m/s, of the fastest particle at the end
  double cpu_seconds = 0;
};

// Uses critical drag for an oscillation of `slowest` = w rad/s, so that all faster ones decay at least like
// exp(-w t); runs for 60 / w seconds. H4 and H6 add their own damping, w^2 h for an oscillation w. So the
// slowest one creeps, at the rate w (1 + d - sqrt(2 d + d^2)), d = w h / 2: at w h = 0.5 the rate is half of
// w, and 1e-13 of the initial deviation is left. If there is no slowest oscillation (NaN) the hair is not
// moved, and the run counts as broken.
Settled settle(const StrandStart& start, const Material& material, Method method, double slowest, double step,
               const ValidationSettings& settings);

}  // namespace hair

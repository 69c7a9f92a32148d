// The pendulum's period, by theory and by the exercises.
#pragma once

#include "hair/lab/validate/chain_methods.h"
#include "hair/lab/validate/validation.h"

namespace hair {

// T/T0 of a pendulum that swings out to `angle`, T0 = 2 pi sqrt(l/g) that of a small swing:
//
//   T/T0 = (2/pi) K(sin(angle/2)) = 1 / agm(1, cos(angle/2)),
//
// K the complete elliptic integral of the first kind, agm the arithmetic-geometric mean (L. D. Landau and E.
// M. Lifshitz, "Mechanics", section 11, problem 1; M. Abramowitz and I. A. Stegun, 17.6). 0 <= angle < pi.
double period_ratio(double angle);

// The same of one mass on one link, in `steps_per_small_period` steps for T0: four times the time from its
// release to its lowest point, so that what a method loses when it is fast has no time left to matter. NaN,
// if it never gets there.
double measured_period_ratio(const ChainMethod& method, double angle, int steps_per_small_period,
                             const ValidationSettings& settings);

}  // namespace hair

// The pendulum's period, by theory and with the exercises.
#pragma once

#include "hair/lab/validate/chain_methods.h"
#include "hair/lab/validate/validation.h"

namespace hair {

// T/T0 of a pendulum with the amplitude `angle`, where T0 = 2 pi sqrt(l/g) is the period of a small swing:
//
//   T/T0 = (2/pi) K(sin(angle/2)) = 1 / agm(1, cos(angle/2)),
//
// with K the complete elliptic integral of the first kind and agm the arithmetic-geometric mean (L. D. Landau
// and E. M. Lifshitz, "Mechanics", section 11, problem 1; M. Abramowitz and I. A. Stegun, 17.6). 0 <= angle <
// pi.
double period_ratio(double angle);

// The same measured with one mass on one link, with `steps_per_small_period` steps for T0: four times the
// time from the release to the lowest point, so that a method's later losses don't matter. NaN if the mass
// never gets there.
double measured_period_ratio(const ChainMethod& method, double angle, int steps_per_small_period,
                             const ValidationSettings& settings);

}  // namespace hair

// Measures the oscillation of one mode of a hanging chain. The chain starts at rest in the mode's shape, so
// that the signal is a single sinusoid.
#pragma once

#include "hair/lab/validate/chain_methods.h"
#include "hair/lab/validate/validation.h"

namespace hair {

struct MeasuredMode {
  double square = 0;     // l w^2 / g of a small swing: corrected for dispersion and amplitude
  double tolerance = 0;  // relative, as below
  double decay = 0;      // the amplitude's decay in a step
  double expected_decay = 0, decay_tolerance = 0;
};

// x is the theory's value of `square`; `highest` is that of the chain's fastest mode.
//
// The angle A is the largest with c A^2 (softening, hanging_chain.h) below kSoftest, and at most
// kLargestAngle. Then the error of w is at most the sum of
//
//   (w h)^2 |c| A^2     the step changes c, which is that of the exact equations,
//   other_error         of the method (chain_methods.h),
//   10 r / phase        the resolution of the fit: r is the sinusoid's residual over its amplitude, and
//                       phase its total phase. r is limited to kWorstFit: a signal that is not a sinusoid
//                       must not get a larger tolerance.
//
// The tolerance of w is twice this sum, to cover higher terms, and twice that for the square.
MeasuredMode measure_mode(const ChainMethod& method, const HangingChain& chain, double x, double highest,
                          const ValidationSettings& settings);

// The tolerance of the decay per step is twice the sum of decay_error (chain_methods.h), of (w h)^2 times
// 2 c A^2 (for a single pendulum H6 takes away (3/16) (w h A)^2 per step, 3/2 of that), and of the fit's
// resolution, 10 r / steps.
inline constexpr double kSoftest = 1e-6, kLargestAngle = 1e-3, kWorstFit = 1e-6;

// For reports: the origin of the tolerance.
inline constexpr const char* kModeTolerance =
    "twice the sum of: what a step makes of the swing's size; stretch or solves; what the fit resolves";

}  // namespace hair

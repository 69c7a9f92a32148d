// A mode of a hanging chain, swung and measured: the chain starts at rest in the mode's shape, so that one
// sinusoid is all that there is.
#pragma once

#include "hair/lab/validate/chain_methods.h"
#include "hair/lab/validate/validation.h"

namespace hair {

struct MeasuredMode {
  double square = 0;  // l w^2 / g of a small swing: the integrator's dispersion and the swing's size undone
  double tolerance = 0;  // relative, as below
  double softening = 0;  // what the swing's size did to it, relative: 2 c A^2
  double decay = 0;      // of the amplitude in a step
  double expected_decay = 0, decay_tolerance = 0;
  double step = 0, angle = 0;
  int steps = 0;
};

// x is what theory says of `square`, and `highest` that of the chain's fastest mode.
//
// The angle A is the largest that keeps c A^2 (softening, hanging_chain.h) below kSoftest, and kLargestAngle
// at most. Then w may be off by
//
//   (w h)^2 |c| A^2     by which a step changes c, which is the equations' own,
//   other_error         of the method (chain_methods.h),
//   10 r / phase        what the fit resolves: r is what the sinusoid leaves, relative to its amplitude, and phase all
//                       that it turns. r counts kWorstFit at most: what is no sinusoid is no reason to allow more.
//
// The tolerance is twice their sum, for terms beyond the first, and twice that for a square.
MeasuredMode measure_mode(const ChainMethod& method, const HangingChain& chain, double x, double highest,
                          const ValidationSettings& settings);

// Of the decay in a step it is twice the sum of decay_error (chain_methods.h), of (w h)^2 times `softening` (of
// one pendulum H6 takes (3/16) (w h A)^2 in a step, 3/2 of that), and of what the fit resolves, 10 r / steps.
inline constexpr double kSoftest = 1e-6, kLargestAngle = 1e-3, kWorstFit = 1e-6;

// For reports: where the tolerance comes from.
inline constexpr const char* kModeTolerance =
    "twice the sum of: what a step makes of the swing's size; stretch or solves; what the fit resolves";

}  // namespace hair

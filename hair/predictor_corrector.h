// H6. The lecture's predictor-corrector: an implicit filter, a sharpener, and a second filter. Source: the
// lecture, "Predictor-corrector scheme" (T.-Y. Kim, "The Chronicles of Narnia", Rhythm and Hues), its five
// steps:
//
//   1. v(n+1/2)  = v(n) + dt/2 F(n+1)/m       first implicit solve: solve_implicit with a = dt/2, b = dt
//   2. x(n+1)    = x(n) + dt v(n+1/2)
//   3. x~        = x(n+1) + x_corr            correct_lengths
//   4. v~(n+1/2) = v(n+1/2) + x_corr / dt     impulse: the velocity that belongs to x~
//   5. v(n+1)    = v~(n+1/2) + dt/2 F(n+1)/m  second implicit solve, forces and df/dx at x~ and v~
//
// The second solve is (M - dt/2 df/dv - dt^2/2 df/dx) dv = dt/2 (f + dt df/dx v~). At the end x is x~, and v
// the velocity of step 5.
#pragma once

#include "hair/length_correction.h"
#include "hair/strand.h"
#include "particles/solve_implicit.h"

namespace hair {

// `scratch` has this many columns of 3n numbers.
inline constexpr int kPredictorCorrectorScratch = particles::kImplicitScratch + 10;

// The tolerance and the limit of step 3.
inline constexpr double kLengthTolerance = 1e-12;
inline constexpr int kMostCorrections = 100;

struct StepReport {
  particles::SolveReport filter;         // step 1
  CorrectionReport correction;           // step 3
  particles::SolveReport second_filter;  // step 5
};

// One step of h seconds, h > 0. The masses of `particles` are strand.mass, and its root is pinned. Evaluates
// the force twice. Allocates nothing itself: memory of the functions that it calls does not count.
StepReport predictor_corrector(const particles::Force& force, const particles::Particles& particles,
                               const Strand& strand, double h, double tolerance, particles::State& state,
                               Scratch scratch);

}  // namespace hair

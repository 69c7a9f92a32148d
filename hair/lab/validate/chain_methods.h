// The exercises' methods for a chain with links of fixed length, behind one signature; and the oscillation of
// one mode of the chain by such a method.
#pragma once

#include <string>
#include <vector>

#include "hair/lab/validate/hanging_chain.h"
#include "hair/lab/validate/validation.h"
#include "hair/scene/scene_run.h"

namespace hair {

struct ChainMethod {
  std::string id;    // "h6"
  std::string name;  // "mass-spring, H6"
  std::vector<std::string> exercises;
  int order;  // order of its time error

  // The true frequency from the measured one: undoes the integrator's dispersion (dispersion.h).
  double (*undo)(double measured, double step);

  // For a small oscillation with w^2 = (g/l) x whose phase turns by `turn` in a step.
  using OfMode = double (*)(const HangingChain& chain, double x, double turn);
  OfMode other_error;  // a bound of w's error, relative, from causes other than the step and the amplitude
  OfMode decay;        // the relative loss of amplitude in a step
  OfMode decay_error;  // a bound of that loss' error

  // The moving chain, with one step for each frame. The hinge is particle 0; mass i of the chain is particle
  // i + 1.
  Scene (*scene)(const HangingChain& chain, const particles::State& state, double step);
};

// Stiff springs that the load hardly stretches, moved by H6.
const ChainMethod& chain_by_h6();
// P2's rods, moved by P1's Runge-Kutta method.
const ChainMethod& chain_by_rods();

// The chain at rest, hanging from 0 along -z, with links turned by `angles` towards +x.
particles::State turned(const HangingChain& chain, const Eigen::VectorXd& angles);

// ---- Measuring a mode ----
//
// The chain starts at rest in the mode's shape, so that the signal is a single sinusoid.

struct MeasuredMode {
  double square = 0;     // l w^2 / g of a small swing: corrected for dispersion and amplitude
  double tolerance = 0;  // relative, as below
  double decay = 0;      // the amplitude's decay in a step
  double expected_decay = 0, decay_tolerance = 0;
};

// x is the theory's value of `square`; `highest` is that of the chain's fastest mode.
//
// The angle A is the largest with c A^2 (softening, hanging_chain.h) below 1e-6, and at most 1e-3. Then
// the error of w is at most the sum of
//
//   (w h)^2 |c| A^2     the step changes c, which is that of the exact equations,
//   other_error         of the method,
//   10 r / phase        the resolution of the fit: r is the sinusoid's residual over its amplitude, and
//                       phase its total phase. r is limited to 1e-6: a signal that is not a sinusoid must
//                       not get a larger tolerance.
//
// The tolerance of w is twice this sum, to cover higher terms, and twice that for the square.
//
// The tolerance of the decay per step is twice the sum of decay_error, of (w h)^2 times 2 c A^2 (for a single
// pendulum H6 takes away (3/16) (w h A)^2 per step, 3/2 of that), and of the fit's resolution, 10 r / steps.
MeasuredMode measure_mode(const ChainMethod& method, const HangingChain& chain, double x, double highest,
                          const ValidationSettings& settings);

}  // namespace hair

// The ways in which the exercises move a chain whose links keep their length, behind one signature.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hair/lab/validate/hanging_chain.h"
#include "particles/state.h"

namespace hair {

// A chain on its way. The hinge is particle 0, and mass i of the chain particle i + 1.
class MovingChain {
 public:
  virtual ~MovingChain() = default;
  virtual void step() = 0;
  virtual const particles::State& state() const = 0;
};

struct ChainMethod {
  std::string id;    // "h6"
  std::string name;  // "mass-spring, H6"
  std::vector<std::string> exercises;
  int order;  // of its time error

  // The frequency that it was asked to move by, from the one that it moved by (dispersion.h).
  double (*undo)(double measured, double step);

  // A bound of how far a small oscillation of w^2 = (g/l) x is off for other reasons than its step and its
  // amplitude, relative to w.
  double (*other_error)(const HangingChain& chain, double x);

  // What a step that turns by `turn` takes of that oscillation's amplitude, and a bound of how far that is off.
  double (*decay)(const HangingChain& chain, double x, double turn);
  double (*decay_error)(const HangingChain& chain, double x, double turn);

  std::unique_ptr<MovingChain> (*start)(const HangingChain& chain, const particles::State& state,
                                        double step);
};

// Springs that are hardly longer for their load, moved by H6.
const ChainMethod& chain_by_h6();
// P2's rods, moved by P1's Runge-Kutta method.
const ChainMethod& chain_by_rods();

// The chain hangs from 0 along -z, with links turned by `angles` towards +x, at rest.
particles::State turned(const HangingChain& chain, const Eigen::VectorXd& angles);

}  // namespace hair

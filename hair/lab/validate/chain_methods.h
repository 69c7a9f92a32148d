// The exercises' methods for a chain with links of fixed length, behind one signature.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hair/lab/validate/hanging_chain.h"
#include "particles/state.h"

namespace hair {

// A moving chain. The hinge is particle 0; mass i of the chain is particle i + 1.
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
  int order;  // order of its time error

  // The true frequency from the measured one: undoes the integrator's dispersion (dispersion.h).
  double (*undo)(double measured, double step);

  // A bound of a small oscillation's frequency error, relative to w, from causes other than the step and the
  // amplitude. The oscillation has w^2 = (g/l) x.
  double (*other_error)(const HangingChain& chain, double x);

  // The relative loss of that oscillation's amplitude in a step whose phase turns by `turn`; and a bound for
  // its error.
  double (*decay)(const HangingChain& chain, double x, double turn);
  double (*decay_error)(const HangingChain& chain, double x, double turn);

  std::unique_ptr<MovingChain> (*start)(const HangingChain& chain, const particles::State& state,
                                        double step);
};

// Stiff springs that the load hardly stretches, moved by H6.
const ChainMethod& chain_by_h6();
// P2's rods, moved by P1's Runge-Kutta method.
const ChainMethod& chain_by_rods();

// The chain at rest, hanging from 0 along -z, with links turned by `angles` towards +x.
particles::State turned(const HangingChain& chain, const Eigen::VectorXd& angles);

}  // namespace hair

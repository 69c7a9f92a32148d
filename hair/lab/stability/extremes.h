// What each method does in extreme cases: hair that is folded, crushed, torn, flung, hung with a weight, or made stiff.
//
// No air drags, and so the true motion keeps its energy, counted from what hair that hangs at rest has, and relative to
// the root, which moves steadily. What became of a run is said in the words of maps:
//
//   blown up     the simulation says so, or at the end it has kBlownEnergy times the energy of the start
//   wrong        at some moment more than kWrongEnergy times the energy of the start
//   damped out   at the end less than a tenth of it
//   stable       none of these
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "hair/lab/stability/experiment.h"

namespace hair {

inline constexpr double kWrongEnergy = 2, kBlownEnergy = 1000;
inline constexpr double kExtremeDuration = 0.5;  // s
inline constexpr long kMostExtremeSteps = 4000;  // of a step that is short

struct ExtremeCase {
  std::string name;  // "torn to thrice its length"
  StrandStart start;
};

struct ExtremeRun {
  std::string extreme;
  StudyMethod method;
  double h = 0;           // s
  std::string step_from;  // where h is the method's own: "half its limit"
  Fate fate = Fate::stable;
  std::string blow_up;  // where it broke: "step 12: integration"
  long steps = 0;
  double stretch = 0;       // the largest |l - l0| / l0 after a step
  double last_stretch = 0;  // at the end
  double most_energy = 0;   // over that at the start
  double last_energy = 0;
};

// Of the description's strand: straight, in its own directions. Without gravity those that would not move are left out.
std::vector<ExtremeCase> extreme_cases(const Description& hair);

// With steps of 1/60 s and 1/240 s, and explicit methods with half their limit for hair that hangs, too. In the order of cases.
// Empty where `interrupted`.
std::vector<ExtremeRun> run_extremes(const Description& hair, const StudyMethod& method,
                                     const std::atomic<bool>& interrupted);

}  // namespace hair

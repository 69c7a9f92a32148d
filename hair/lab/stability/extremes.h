// The behaviour of each method in extreme cases: hair that is folded, crushed, torn, flung, hung with a
// weight, or made stiff.
//
// There is no drag, so the true motion keeps its energy. Energies are relative to hair that hangs at rest,
// and velocities relative to the root, which moves steadily. The classes have the same names as in the maps:
//
//   blown up     the simulation reports a blow-up, or the end has kBlownEnergy times the energy of the start
//   wrong        at some moment more than kWrongEnergy times the energy of the start
//   damped out   at the end less than a tenth of the energy of the start
//   stable       none of these
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "hair/lab/stability/experiment.h"

namespace hair {

inline constexpr double kWrongEnergy = 2, kBlownEnergy = 1000;
inline constexpr double kExtremeDuration = 0.5;  // s
inline constexpr long kMostExtremeSteps = 4000;  // for short steps

struct ExtremeCase {
  std::string name;  // "torn to thrice its length"
  StrandStart start;
};

struct ExtremeRun {
  std::string extreme;
  StudyMethod method;
  double h = 0;           // s
  std::string step_from;  // only if h is the method's own: "half its limit"
  Fate fate = Fate::stable;
  std::string blow_up;  // the place of the blow-up: "step 12: integration"
  long steps = 0;
  double stretch = 0;       // the largest |l - l0| / l0 after a step
  double last_stretch = 0;  // at the end
  double most_energy = 0;   // relative to the energy at the start
  double last_energy = 0;
};

// The cases for the description's strand, made straight, in its own directions. Without gravity, leaves out
// the cases that would not move.
std::vector<ExtremeCase> extreme_cases(const Description& hair);

// Runs with steps of 1/60 s and 1/240 s; explicit methods also with half their limit for hanging hair. In the
// order of cases. Empty if `interrupted`.
std::vector<ExtremeRun> run_extremes(const Description& hair, const StudyMethod& method,
                                     const std::atomic<bool>& interrupted);

}  // namespace hair

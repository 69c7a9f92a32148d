// One cell of a stability map: hanging hair with a small disturbance, a method that moves it for a number of
// steps, and the outcome.
//
// In the true motion each mode keeps the energy of its disturbance, except for the known loss by drag. So the
// classes are:
//
//   blown up     the simulation reports a blow-up (an impossible number), or the hair moves with more energy
//                than it would take to throw it over its root: kinetic energy above 2 m g L and above 1e6
//                times the disturbance's
//   wrong        all numbers are finite, but at some moment a mode has 100 times its initial energy: ten
//                times the motion, without a cause
//   damped out   less than a tenth of the expected energy is left, at a moment when drag has left at least a
//                hundredth of it
//   stable       none of these
//
// The first class that applies counts. Why 100 and not 2: near its limit symplectic Euler keeps errors
// bounded but exchanges energy, by the factor (1 + h omega/2) / (1 - h omega/2), which is 100 at 0.98 of the
// limit.
#pragma once

#include "hair/lab/stability/hanging.h"
#include "hair/lab/study/study_methods.h"

namespace hair {

enum class Fate { stable, damped_out, wrong, blown_up };
inline constexpr int kFates = 4;
const char* fate_name(Fate fate);

inline constexpr double kWrongGrowth = 100;  // times a mode's energy
inline constexpr double kLostEnergy = 0.1;   // part of the expected energy
inline constexpr double kStillThere = 0.01;  // part of the disturbance's energy, after drag
inline constexpr int kLooks = 32;            // equally spaced moments in a run

struct Outcome {
  Fate fate = Fate::stable;
  long steps = 0;  // the steps taken: a run ends as soon as it blows up
  double growth =
      0;  // the largest energy of a mode at any moment, relative to its initial energy; of finite ones only
  double kept = 1;  // energy over expected energy, at the last moment when drag leaves enough
};

// Runs `steps` steps of size h. Uses the method's options of the description and ignores its strands, step
// and drag.
Outcome run_disturbed(const Description& hair, const Hanging& hanging, const Disturbance& disturbance,
                      double drag, double h, long steps);

// The energy after t seconds, relative to the start, of an oscillator that started with a velocity only.
double oscillator_energy(double omega, double gamma, double t);

// The same judgement for any measured trajectory. Takes the energies of the modes at each moment and their
// expected mean, relative to the initial energy of each mode. `kinetic` is the kinetic energy over the bound
// above.
class Judge {
 public:
  // Returns true if the hair has blown up, so that the run can end.
  bool look(const Eigen::VectorXd& energies, double kinetic, double true_mean);
  void broke() { outcome_.fate = Fate::blown_up; }
  const Outcome& outcome() const { return outcome_; }

 private:
  Outcome outcome_;
};

}  // namespace hair

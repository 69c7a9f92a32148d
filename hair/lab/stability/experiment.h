// One cell of a stability map: hair that hangs, disturbed a little, is moved by a method for so many steps, and what
// became of it.
//
// The true motion keeps the disturbance's energy, mode by mode, but for what drag takes, and that is known. So:
//
//   blown up     the simulation says so (a number that no hair has), or the hair moves with more energy than it would take to
//                throw it over its root: kinetic energy above 2 m g L and above 1e6 of the disturbance's
//   wrong        all numbers are finite, but at some moment a mode has 100 times the energy that it was given: ten times the
//                motion, and nothing that could have done so
//   damped out   less than a tenth of the energy that should be there is left, at a moment when drag has left a
//                hundredth of it
//   stable       none of these
//
// The first that holds is what a cell is. 100 and not 2: near its limit symplectic Euler keeps errors bounded and yet
// exchanges energy, by (1 + h omega/2) / (1 - h omega/2), which is 100 at 0.98 of the limit.
#pragma once

#include <optional>
#include <string>

#include "hair/lab/stability/hanging.h"
#include "hair/lab/study/study_methods.h"

namespace hair {

enum class Fate { stable, damped_out, wrong, blown_up };
inline constexpr int kFates = 4;
const char* fate_name(Fate fate);

inline constexpr double kWrongGrowth = 100;  // of a mode's energy
inline constexpr double kLostEnergy = 0.1;   // of what should be there
inline constexpr double kStillThere = 0.01;  // of the disturbance's energy, after drag
inline constexpr int kLooks = 32;            // moments in a run, at equal distances

struct Outcome {
  Fate fate = Fate::stable;
  long steps = 0;  // that were taken: a run ends as soon as it has blown up
  double growth =
      0;  // the largest energy of a mode at any moment, over what it was given; of those that are finite
  double kept = 1;  // the energy at the last moment that drag leaves enough, over what should be there
};

// Runs `steps` steps of size h. The description has the method's options; its strands, step and drag don't matter.
Outcome run_disturbed(const Description& hair, const Hanging& hanging, const Disturbance& disturbance,
                      double drag, double h, long steps);

// The energy after t seconds, in parts of that at the start, of an oscillator that started with a velocity alone.
double oscillator_energy(double omega, double gamma, double t);

// The same of what was measured, for any trajectory: energies of modes at moments, and what they should be in sum, in
// parts of the energy that each was given. `kinetic` is that of the moment over the bound above.
class Judge {
 public:
  // Whether it has blown up, so that the run can end.
  bool look(const Eigen::VectorXd& energies, double kinetic, double true_mean);
  void broke() { outcome_.fate = Fate::blown_up; }
  const Outcome& outcome() const { return outcome_; }
  Outcome& outcome() { return outcome_; }

 private:
  Outcome outcome_;
};

}  // namespace hair

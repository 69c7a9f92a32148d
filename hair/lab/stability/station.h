// A column of a map: hair that hangs, disturbed, with one stiffness and one drag. It gives the outcome for a
// step, and the theory's, for any model.
#pragma once

#include <functional>

#include "hair/lab/stability/experiment.h"

namespace hair {

struct Station {
  // Makes a run of so many steps.
  std::function<Outcome(double h, long steps)> run;
  // The largest step with which no error grows by more than `growth` in a step; infinity if that is above
  // `most`.
  std::function<double(double growth, double most)> limit;
};

// Relative to the scene's stiffness. `hair` has the method's options (with_options).
Station make_station(const Description& hair, const StudyMethod& method, double stiffness, double drag);

// The scales of a map's axes.
struct MapScales {
  double frequency;      // 1/s: the fastest of all; for implicit methods, the fastest that weight alone holds
  double critical_drag;  // N s/m^2, per metre: damps an oscillation of this frequency critically
};
MapScales map_scales(const Description& hair, const StudyMethod& method);

}  // namespace hair

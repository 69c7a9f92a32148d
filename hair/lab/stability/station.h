// A column of a map: hair that hangs, disturbed, with one stiffness and one drag. What becomes of it with a
// step, and what theory says; for any model.
#pragma once

#include <functional>

#include "hair/lab/stability/experiment.h"

namespace hair {

struct Station {
  // A run of so many steps.
  std::function<Outcome(double h, long steps)> run;
  // The largest step with which nothing grows by more than `growth` in a step; infinity if that is above
  // `most`.
  std::function<double(double growth, double most)> limit;
};

// Relative to the scene's stiffness. `hair` has the method's options (with_options).
Station make_station(const Description& hair, const StudyMethod& method, double stiffness, double drag);

// What a map's axes count from.
struct MapScales {
  double
      frequency;  // 1/s: of explicit methods the fastest of all, of implicit ones the fastest that weight alone holds
  double critical_drag;  // N s/m^2, for each metre: damps an oscillation of this frequency critically
};
MapScales map_scales(const Description& hair, const StudyMethod& method);

}  // namespace hair

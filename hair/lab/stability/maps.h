// Stability maps of a method: the outcome for a hanging strand with a small disturbance, over a grid of step
// sizes and stiffnesses, or of step sizes and drags; and the distance between the measured boundary and the
// theory's.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "hair/lab/stability/experiment.h"
#include "hair/lab/stability/refine.h"

namespace hair {

enum class Swept {
  stiffness,  // Young's modulus relative to the scene's: scales EA and EI together, with the scene's drag
  drag        // N s/m per metre of hair, with the scene's stiffness
};
inline const char* name_of(Swept swept) {
  return swept == Swept::stiffness ? "stiffness" : "drag";
}

struct MapSettings {
  int columns = 80, rows = 80;
  long evaluations =
      4000;  // force evaluations of an explicit method's run, at most: RK4 takes a quarter as many steps
  long implicit_steps = 64;
};

// The distance of the measured boundary from a limit: > 0 means stable beyond theory.
struct Distance {
  int columns = 0;  // columns where both are on the map; the next three numbers are over these columns
  double median_cells = 0, worst_cells = 0;
  double median_relative = 0;  // measured over limit, less 1
  // The number of columns where one or both have left the map although they are more than a cell apart; and
  // the largest of these distances, counted up to the map's edge: a lower bound.
  int columns_beyond = 0;
  double beyond_cells = 0;
};

// A theoretical curve in a map.
struct Limit {
  std::string name;       // "theory: 2/omega"
  std::vector<double> h;  // for each column, s; infinity: no limit; 0: no step is stable
  bool of_run = false;    // true: not the method's limit, but what a run of so few steps can detect
  Distance distance = {};
};

struct StabilityMap {
  StudyMethod method;
  std::vector<StudyMethod> alike;  // methods with the same matrix for this hair: the map holds for them too
  Swept sweep = Swept::stiffness;
  std::vector<double> xs, hs;  // the centres of the cells; hs in s
  RefinedGrid grid;            // classes are Fate
  long steps = 0;              // steps of a run without a blow-up
  std::vector<double>
      boundary;  // for each column, s: no smaller step is wrong or blown up; infinity if no step is
  std::vector<Limit> limits;
  double cpu_seconds = 0;
};

// The measured boundary of a grid, at the edge between two cells; 0 if the lowest cell is already wrong.
std::vector<double> boundary_of(const RefinedGrid& grid, const std::vector<double>& hs);
Distance distance_of(const std::vector<double>& boundary, const std::vector<double>& limit,
                     const std::vector<double>& hs);

// Called after each cell with the number of runs so far.
using Progress = std::function<void(long runs)>;

// Maps one strand's problem with a method that fits it. Passes on exceptions of stubs. grid.complete is false
// if the function was interrupted.
StabilityMap make_map(const Description& hair, const StudyMethod& method, Swept sweep,
                      const MapSettings& settings, const std::atomic<bool>& interrupted,
                      const Progress& progress = {});

// True if two methods have the same matrix for hanging hair, for all stiffnesses of a map, and are equal
// otherwise.
bool alike_when_hanging(const Description& hair, const StudyMethod& a, const StudyMethod& b);

}  // namespace hair

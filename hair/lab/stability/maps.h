// Stability maps of a method: what becomes of a strand that hangs and is disturbed a little, for each of a grid of step
// sizes and stiffnesses, or step sizes and drags; and how far the boundary that was found is from theory's.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "hair/lab/stability/experiment.h"
#include "hair/lab/stability/refine.h"

namespace hair {

enum class Swept {
  stiffness,  // Young's modulus, times the scene's: EA and EI together, with the scene's drag
  drag        // N s/m for each metre of hair, with the scene's stiffness
};

struct MapSettings {
  int columns = 80, rows = 80;
  long evaluations =
      4000;  // of forces, that an explicit method's run may take: RK4 has a quarter as many steps
  long implicit_steps = 64;
};

// A curve that theory draws into a map.
struct Limit {
  std::string name;       // "theory: 2/omega"
  std::vector<double> h;  // of each column, s; infinity where there is none, 0 where no step is stable
  bool of_run = false;    // not the method's limit, but what so few steps can show of it
};

// How far the measured boundary is from a limit: > 0 is stable beyond theory.
struct Distance {
  int columns = 0;  // where both are on the map, which the next three are of
  double median_cells = 0, worst_cells = 0;
  double median_relative = 0;  // measured over limit, less 1
  // Columns where one of them or both have left the map, and they are more than a cell apart all the same; and
  // the largest of these distances, each counted to the map's edge: it is at least that.
  int columns_beyond = 0;
  double beyond_cells = 0;
};

struct StabilityMap {
  StudyMethod method;
  std::vector<StudyMethod>
      alike;  // methods that make the same matrix of this hair, which this map is of as well
  Swept sweep = Swept::stiffness;
  std::vector<double> xs, hs;  // the cells' middles; hs in s
  RefinedGrid grid;            // of Fate
  long steps = 0;              // of a run that does not blow up
  std::vector<double>
      boundary;  // of each column, s: below it nothing is wrong or blown up; infinity where nothing is
  std::vector<Limit> limits;
  std::vector<Distance> distances;  // of each limit
  double cpu_seconds = 0;
};

// The measured boundary of a grid, at the edge between two cells; 0 where the lowest cell is wrong already.
std::vector<double> boundary_of(const RefinedGrid& grid, const std::vector<double>& hs);
Distance distance_of(const std::vector<double>& boundary, const std::vector<double>& limit,
                     const std::vector<double>& hs);

// Called after each cell with the number of runs so far.
using Progress = std::function<void(long runs)>;

// The problem is one strand's; the method fits it. What a stub throws, passes. grid.complete says whether it was
// interrupted.
StabilityMap make_map(const Description& hair, const StudyMethod& method, Swept sweep,
                      const MapSettings& settings, const std::atomic<bool>& interrupted,
                      const Progress& progress = {});

// Whether two methods' matrices are the same for hair that hangs, for all stiffnesses of a map, and nothing else differs.
bool alike_when_hanging(const Description& hair, const StudyMethod& a, const StudyMethod& b);

// A description with a method's options.
Description with_options(Description hair, const StudyMethod& method);

}  // namespace hair

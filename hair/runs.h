// A few small scenes that run end to end through the exercises: what they show is whether everything fits
// together. Each is plain data, made here, and lasts a few milliseconds.
#pragma once

#include <string>
#include <vector>

#include "particles/state.h"

namespace hair {

struct Frame {
  double time;             // s
  particles::State state;  // of all particles, strand after strand; particles in the run's order
  double stretch;          // the largest |l - l0| / l0 of all segments, springs or rods
  double energy;           // J, kinetic and potential
};

struct Run {
  std::string name;                    // "strand-swing"
  std::string shows;                   // one line
  std::vector<std::string> exercises;  // whose functions it calls: {"S1", "H1", ...}
  std::vector<int> strands;            // the number of particles of each strand; their sum is that of all
};

struct RunResult {
  std::vector<Frame> frames;  // at equal times, the first at the start; all numbers finite
  std::string trouble;        // empty, or where the run broke: "strand 0, step 17: filter"
};

const std::vector<Run>& runs();

// Does the run of that name. An exercise that is not implemented throws what its stub throws. What breaks
// ends early, with the frames until then. Throws std::invalid_argument for a name that no run has.
RunResult do_run(const std::string& name);

}  // namespace hair

// STAFF ONLY.
#include "grader/exercise/P2/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::p2 {

WholeRunPoints whole_run() {
  return {1, 2};
}

std::vector<Category> categories() {
  return {{"RodValues", "Values and rates of rods", 2, rod_values},
          {"WireValues", "Values and rates of wires", 2, wire_values},
          {"RodForces", "Forces of rods", 1, rod_forces},
          {"WireForces", "Forces of wires", 1, wire_forces},
          {"Matrix", "The matrix", 1, matrix},
          {"AtRest", "Particles at rest", 1, particles_at_rest},
          {"Moving", "Particles that move", 1, particles_that_move},
          {"Wires", "Beads on wires", 1, beads_on_wires},
          {"Feedback", "Feedback", 1, feedback},
          {"Pinned", "Pinned particles", 1, pinned_particles},
          {"Redundant", "Redundant constraints", 1, redundant},
          {"Energy", "Energy in a swing", 1, energy},
          {"Report", "Tolerance and report", 1, tolerance_and_report}};
}

}  // namespace grader::p2

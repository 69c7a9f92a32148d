// STAFF ONLY. The categories of P2 and their points.
#include "grader/exercise/P2/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::p2 {

WholeRunPoints whole_run() {
  return {1, 1};
}

std::vector<Category> categories() {
  return {{"RodValues", "Values and rates of rods", 2, rod_values},
          {"WireValues", "Values and rates of wires", 1, wire_values},
          {"RodForces", "Forces of rods", 1, rod_forces},
          {"WireForces", "Forces of wires", 1, wire_forces},
          {"Matrix", "The matrix", 1, matrix},
          {"Solve", "Constraint forces", 4, constraint_forces},
          {"Feedback", "Feedback", 1, feedback},
          {"Pinned", "Pinned particles", 1, pinned_particles},
          {"Nothing", "Nothing to hold", 1, nothing_to_hold},
          {"Rows", "Rods and wires together", 1, rods_and_wires},
          {"Units", "A small unit of length", 1, small_unit},
          {"Report", "Tolerance and report", 1, tolerance_and_report}};
}

}  // namespace grader::p2

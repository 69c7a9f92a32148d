// STAFF ONLY. The cases of each category of P2.
#include "reference/P2/cases.h"

namespace grader::p2 {

Cases cases() {
  return {{"RodValues", rod_values},   {"WireValues", wire_values},  {"RodForces", rod_forces},
          {"WireForces", wire_forces}, {"Matrix", matrix},           {"Solve", constraint_forces},
          {"Feedback", feedback},      {"Pinned", pinned_particles}, {"Nothing", nothing_to_hold},
          {"Rows", rods_and_wires},    {"Units", small_unit},        {"Report", tolerance_and_report}};
}

}  // namespace grader::p2

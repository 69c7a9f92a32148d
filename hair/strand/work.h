// The effort of steps. Each step adds its numbers.
#pragma once

#include <algorithm>

namespace hair {

struct Work {
  long strand_steps = 0;      // steps times strands
  long solver_steps = 0;      // iterations of ConjGrad
  long plain_solves = 0;      // solves that had no preconditioner
  long correction_steps = 0;  // Newton steps of the length correction
  long solves = 0;            // solves and corrections
  long unconverged = 0;       // those that ended above their tolerance
  long unmended = 0;          // collisions after which obstacles and lengths did not agree (H6)
  long kept_steps = 0;        // steps of rigid links with momenta of the step before
  long contacts = 0;          // particles that were pushed out of an obstacle
  double penetration = 0;     // m, the largest depth of a particle that remained in an obstacle

  Work& operator+=(const Work& other) {
    strand_steps += other.strand_steps;
    solver_steps += other.solver_steps;
    plain_solves += other.plain_solves;
    correction_steps += other.correction_steps;
    solves += other.solves;
    unconverged += other.unconverged;
    unmended += other.unmended;
    kept_steps += other.kept_steps;
    contacts += other.contacts;
    penetration = std::max(penetration, other.penetration);
    return *this;
  }
};

}  // namespace hair

// The effort of steps. Each step adds its numbers.
#pragma once

namespace hair {

struct Work {
  long strand_steps = 0;      // steps times strands
  long solver_steps = 0;      // iterations of ConjGrad
  long plain_solves = 0;      // solves that had no preconditioner
  long correction_steps = 0;  // Newton steps: of the length correction, or of newton_euler
  long halvings = 0;          // of newton_euler's steps: each evaluates the forces once more
  long unconverged = 0;       // solves and corrections that ended above their tolerance
  long unmended = 0;          // collisions after which obstacles and lengths did not agree (H6)
  long contacts = 0;          // particles that were pushed out of an obstacle
  double penetration = 0;     // m, the largest depth of a particle that remained in an obstacle
};

}  // namespace hair
